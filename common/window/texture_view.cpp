// SPDX-License-Identifier: MIT
#include "texture_view.hpp"

#include <algorithm>
#include <cmath>

#include "image/cube_faces.hpp"
#include "window/gui.hpp"

namespace texel::window {
namespace {

constexpr int kWhole = 256, kSmall = 64;  // texels a side that are enough for the pictures

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
  const GLint filter = gl::value_of(glGetTexParameteriv, target, GL_TEXTURE_MIN_FILTER);
  view.is_mipmapped = filter != GL_NEAREST && filter != GL_LINEAR;
  view.level_of_detail = view.footprint.level(view.size_of(0), view.is_mipmapped ? anisotropy : 1);
  const double level = std::clamp(view.level_of_detail, 0.0, view.levels - 1.0);
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

/// A point, of the pixel with this column and row of the 3x3; nothing where it has no value.
std::optional<Footprint> place_at(const image::ImageF& around, int x, int y, bool is_cube) {
  const glm::dvec3 value(around.at(x, y, 0), around.at(x, y, 1), around.at(x, y, 2));
  if (around.at(x, y, 3) <= 0 || !std::isfinite(value.x + value.y + value.z)) return std::nullopt;
  if (!is_cube) return Footprint{.place = value};
  if (value == glm::dvec3(0)) return std::nullopt;
  const image::FaceCoordinate met = image::face_coordinate(value);
  return Footprint{.place = {met.s, met.t}, .face = static_cast<int>(met.face)};
}

}  // namespace

glm::dvec2 Footprint::sides(glm::dvec2 size) const {
  const double a = glm::length(dx * size), b = glm::length(dy * size);
  return {std::max(a, b), std::min(a, b)};
}

double Footprint::level(glm::dvec2 size, double anisotropy) const {
  constexpr double kLeast = 0x1p-50;  // as in shaders/lib/level_of_detail.glsl: nothing changes
  const glm::dvec2 side = glm::max(sides(size), glm::dvec2(kLeast));
  return std::log2(side.x / std::clamp(std::ceil(side.x / side.y), 1.0, std::max(anisotropy, 1.0)));
}

std::optional<Footprint> footprint_of(const image::ImageF& around, bool is_cube) {
  std::optional<Footprint> middle = place_at(around, 1, 1, is_cube);
  if (!middle) return std::nullopt;
  const auto step = [&](glm::ivec2 to) {
    std::optional<glm::dvec2> shortest;
    for (const int side : {1, -1}) {
      const std::optional<Footprint> neighbour = place_at(around, 1 + side * to.x, 1 + side * to.y, is_cube);
      if (!neighbour || neighbour->face != middle->face) continue;
      const glm::dvec2 moved = static_cast<double>(side) * (neighbour->place - middle->place);
      if (!shortest || glm::length(moved) < glm::length(*shortest)) shortest = moved;
    }
    return shortest.value_or(glm::dvec2(0));
  };
  middle->dx = step({1, 0}), middle->dy = step({0, 1});
  return middle;
}

double wrapped(double coordinate, unsigned mode) {
  const double tile = std::floor(coordinate), within = coordinate - tile;
  if (mode == GL_REPEAT) return within;
  if (mode == GL_MIRRORED_REPEAT) return std::fmod(tile, 2) != 0 ? 1 - within : within;
  return std::clamp(coordinate, 0.0, 1.0);
}

glm::ivec2 TextureView::size_of(int level) const {
  return glm::max(glm::ivec2(width >> level, height >> level), glm::ivec2(1));
}

std::vector<TextureView> textures_at(app::Canvas& canvas, app::AnyLab& lab, glm::ivec2 size,
                                     glm::ivec2 pixel) {
  std::vector<TextureView> views;
  const std::vector<gl::Record::TextureUse> textures = canvas.textures(size);
  for (const gl::Record::TextureUse& texture : textures) {
    if (std::ranges::count(textures, texture.name, &gl::Record::TextureUse::name) > 1) continue;
    const app::View source = texture.is_cube ? app::View::direction : app::View::texcoord;
    if (std::ranges::count(lab.views(), source) == 0) continue;
    const std::optional<Footprint> footprint = footprint_of(
        image::square_around(canvas.values_of(source, size), pixel.x, pixel.y, 3), texture.is_cube);
    if (!footprint) continue;
    const GLenum target = texture.is_cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    const gl::ScopedBinding binding(target, texture.id);
    TextureView view(texture);
    view.wrap_s = static_cast<unsigned>(gl::value_of(glGetTexParameteriv, target, GL_TEXTURE_WRAP_S));
    view.wrap_t = static_cast<unsigned>(gl::value_of(glGetTexParameteriv, target, GL_TEXTURE_WRAP_T));
    view.footprint = *footprint;
    find_levels(view, target);
    read_pictures(view);
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace texel::window
