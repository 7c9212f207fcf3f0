// SPDX-License-Identifier: MIT
#include "gl/upload.hpp"

#include <algorithm>

#include "core/parallel.hpp"
#include "core/stages.hpp"
#include "image/mipmaps.hpp"

namespace texel::gl {

Format format_of(int channels, image::Encoding encoding) {
  static constexpr Format kLinear[] = {
      {GL_R8, GL_RED}, {GL_RG8, GL_RG}, {GL_RGB8, GL_RGB}, {GL_RGBA8, GL_RGBA}};
  if (encoding == image::Encoding::srgb && channels == 3) return {GL_SRGB8, GL_RGB};
  if (encoding == image::Encoding::srgb && channels == 4) return {GL_SRGB8_ALPHA8, GL_RGBA};
  return kLinear[channels - 1];
}

image::Image8 expand_gray(const image::Image8& image) {
  if (image.channels > 2) return image;
  image::Image8 color(image.width, image.height, image.channels + 2);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < color.channels; ++c)
        color.at(x, y, c) = image.at(x, y, c / 3);  // alpha is the second
  return color;
}

GLint texture_units() {
  return integer(GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS);
}

void unbind_textures() {
  for (GLint unit = texture_units() - 1; unit >= 0; --unit) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindTexture(GL_TEXTURE_CUBE_MAP, 0);
  }
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

void set_sampling(GLenum target, const Sampling& sampling) {
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(sampling.minify));
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(sampling.magnify));
  glTexParameteri(target, GL_TEXTURE_WRAP_S, static_cast<GLint>(sampling.wrap_s));
  glTexParameteri(target, GL_TEXTURE_WRAP_T, static_cast<GLint>(sampling.wrap_t));
  if (GLAD_GL_EXT_texture_filter_anisotropic != 0) {
    float most = 1;
    if (sampling.anisotropy > 1) glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
    glTexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, std::clamp(sampling.anisotropy, 1.0F, most));
  }
}

void forget_sampling(const Texture& texture) {
  const ScopedBinding binding(GL_TEXTURE_2D, texture);
  set_sampling(GL_TEXTURE_2D, {.minify = GL_NEAREST_MIPMAP_LINEAR});
}

ScopedBinding::ScopedBinding(GLenum target, GLuint texture)
    : target_(target),
      before_(integer(target == GL_TEXTURE_2D ? GL_TEXTURE_BINDING_2D : GL_TEXTURE_BINDING_CUBE_MAP)) {
  glBindTexture(target, texture);
}

void upload_level(GLenum target, int level, const image::Image8& image, image::Encoding encoding) {
  const Stage stage("upload");
  const Format format = format_of(image.channels, encoding);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(target, level, static_cast<GLint>(format.internal), image.width, image.height, 0,
               format.external, GL_UNSIGNED_BYTE, image.samples.data());
}

namespace {

/// The levels that the sampling reads, the whole picture first; colours in a format that the GPU decodes.
std::vector<image::Image8> levels_for(const image::Image8& image, image::Encoding encoding,
                                      const Sampling& sampling) {
  const image::Image8 whole = encoding == image::Encoding::srgb ? expand_gray(image) : image;
  if (sampling.minify == GL_NEAREST || sampling.minify == GL_LINEAR) return {whole};
  return image::mip_chain(whole, encoding);
}

void upload_levels(GLenum target, const std::vector<image::Image8>& levels, image::Encoding encoding) {
  int level = 0;
  for (const image::Image8& image : levels) upload_level(target, level++, image, encoding);
}

}  // namespace

Texture make_texture_2d(const image::Image8& image, image::Encoding encoding, const Sampling& sampling) {
  Texture texture;
  const ScopedBinding binding(GL_TEXTURE_2D, texture);
  upload_levels(GL_TEXTURE_2D, levels_for(image, encoding, sampling), encoding);
  set_sampling(GL_TEXTURE_2D, sampling);
  return texture;
}

Texture make_cube_map(std::span<const image::Image8, 6> faces, image::Encoding encoding,
                      const Sampling& sampling) {
  Texture texture;
  const ScopedBinding binding(GL_TEXTURE_CUBE_MAP, texture);
  std::array<std::vector<image::Image8>, 6> levels;
  {
    const Stage stage("mipmaps");
    in_parallel(processors(), 6,
                [&](std::size_t i) { levels[i] = levels_for(faces[i], encoding, sampling); });
  }
  for (GLuint i = 0; i < 6; ++i) upload_levels(GL_TEXTURE_CUBE_MAP_POSITIVE_X + i, levels[i], encoding);
  set_sampling(GL_TEXTURE_CUBE_MAP, sampling);
  return texture;
}

void bind(int unit, GLenum target, const Texture& texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(target, texture.id());
}

}  // namespace texel::gl
