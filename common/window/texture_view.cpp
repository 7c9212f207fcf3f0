// SPDX-License-Identifier: MIT
#include "texture_view.hpp"

#include <algorithm>
#include <cmath>

#include "picture_texture.hpp"

namespace texel::window {
namespace {

constexpr int kWhole = 256, kSmall = 64;  // texels a side that are enough for the pictures

GLint parameter_of(GLenum target, GLenum name) {
  GLint value = 0;
  glGetTexParameteriv(target, name, &value);
  return value;
}

/// A level of the bound texture, as it is stored.
image::Image8 read_level(GLenum face, int level) {
  GLint width = 0, height = 0;
  glGetTexLevelParameteriv(face, level, GL_TEXTURE_WIDTH, &width);
  glGetTexLevelParameteriv(face, level, GL_TEXTURE_HEIGHT, &height);
  image::Image8 picture(width, height, 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTexImage(face, level, GL_RGBA, GL_UNSIGNED_BYTE, picture.samples.data());
  return picture;
}

/// What the filter does with the footprint.
void find_levels(TextureView& view, GLenum target) {
  GLfloat anisotropy = 1;
  glGetTexParameterfv(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, &anisotropy);
  const GLint filter = parameter_of(target, GL_TEXTURE_MIN_FILTER);
  view.is_mipmapped = filter != GL_NEAREST && filter != GL_LINEAR;
  view.level = view.footprint.level(view.size, view.is_mipmapped ? anisotropy : 1);
  const double level = std::clamp(view.level, 0.0, view.levels - 1.0);
  if (!view.is_mipmapped) return;
  const bool mixes = filter == GL_NEAREST_MIPMAP_LINEAR || filter == GL_LINEAR_MIPMAP_LINEAR;
  view.first_read = static_cast<int>(mixes ? std::floor(level) : std::round(level));
  view.last_read = static_cast<int>(mixes ? std::ceil(level) : std::round(level));
}

/// The pictures of the texture that is bound.
void read_pictures(TextureView& view) {
  const GLenum first = view.is_cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : GL_TEXTURE_2D;
  const GLenum face = first + static_cast<GLenum>(view.footprint.face);
  // The first level of at most so many texels a side, or the last.
  const auto level_below = [&](int most) {
    int level = 0;
    while (level + 1 < view.levels && std::max(view.size_of(level).x, view.size_of(level).y) > most) ++level;
    return level;
  };
  for (GLenum i = 0; i < (view.is_cube ? 6U : 1U); ++i)
    view.whole.push_back(picture_texture(read_level(first + i, level_below(kWhole))));
  view.read = picture_texture(read_level(face, view.first_read), view.wrap_s, view.wrap_t);
  for (int level = 0; level < view.levels; ++level)
    view.chain.push_back(picture_texture(read_level(face, std::max(level, level_below(kSmall)))));
}

}  // namespace

glm::ivec2 TextureView::size_of(int of_level) const {
  return glm::max(glm::ivec2(size.x >> of_level, size.y >> of_level), glm::ivec2(1));
}

std::vector<TextureView> textures_at(app::Canvas& canvas, app::AnyLab& lab, glm::ivec2 size,
                                     glm::ivec2 pixel) {
  const auto has = [&](app::View view) { return std::ranges::count(lab.views(), view) > 0; };
  std::vector<TextureView> views;
  const std::vector<gl::Record::TextureUse> textures = canvas.textures(size);
  for (const gl::Record::TextureUse& texture : textures) {
    if (std::ranges::count(textures, texture.name, &gl::Record::TextureUse::name) > 1) continue;
    if (!has(texture.is_cube ? app::View::direction : app::View::texcoord)) continue;
    const image::ImageF around =
        canvas.values_around(texture.is_cube ? app::View::direction : app::View::texcoord, size, pixel);
    const GLenum target = texture.is_cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    const gl::ScopedBinding binding(target, texture.id);
    TextureView view;
    view.name = texture.name, view.format = texture.format, view.is_cube = texture.is_cube;
    view.size = {texture.width, texture.height}, view.levels = texture.levels;
    view.wrap_s = static_cast<unsigned>(parameter_of(target, GL_TEXTURE_WRAP_S));
    view.wrap_t = static_cast<unsigned>(parameter_of(target, GL_TEXTURE_WRAP_T));
    const std::optional<Footprint> footprint =
        texture.is_cube ? footprint_of_directions(around) : footprint_of_texcoords(around);
    if (!footprint) continue;
    view.footprint = *footprint;
    find_levels(view, target);
    read_pictures(view);
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace texel::window
