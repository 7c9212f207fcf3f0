// SPDX-License-Identifier: MIT
#include "gl/upload.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "core/stages.hpp"
#include "gl/cube_map.hpp"
#include "gl/make_cube_map.hpp"
#include "image/mipmaps.hpp"

namespace texel::gl {

ScopedBinding::ScopedBinding(GLenum target, GLuint texture) : target_(target) {
  glGetIntegerv(target == GL_TEXTURE_2D ? GL_TEXTURE_BINDING_2D : GL_TEXTURE_BINDING_CUBE_MAP, &before_);
  glBindTexture(target, texture);
}

ScopedBinding::~ScopedBinding() {
  glBindTexture(target_, static_cast<GLuint>(before_));
}

void upload_level(GLenum target, int level, const image::Image8& image, image::Encoding encoding) {
  const Stage stage("upload");
  const Format format = format_of(image.channels, encoding);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(target, level, static_cast<GLint>(format.internal), image.width, image.height, 0,
               format.external, GL_UNSIGNED_BYTE, image.samples.data());
}

namespace {

/// A colour picture in a format that the GPU decodes from sRGB.
image::Image8 uploadable(const image::Image8& image, image::Encoding encoding) {
  return encoding == image::Encoding::srgb ? expand_grey(image) : image;
}

bool needs_mipmaps(const Sampling& sampling) {
  return sampling.minify != GL_NEAREST && sampling.minify != GL_LINEAR;
}

/// The levels that the sampling reads, the whole picture first.
std::vector<image::Image8> levels_for(const image::Image8& image, image::Encoding encoding,
                                      const Sampling& sampling) {
  if (!needs_mipmaps(sampling)) return {uploadable(image, encoding)};
  return image::mip_chain(uploadable(image, encoding), encoding);
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

void check_cube_faces(std::span<const image::Image8, 6> faces, const std::string& from) {
  static constexpr const char* kNames[] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  const auto fail = [&](const std::string& what) {
    return Error::failed("the cube map's " + what, {from}, "use six square pictures of the same size");
  };
  for (std::size_t i = 0; i < 6; ++i) {
    const int width = faces[i].width, height = faces[i].height, first = faces[0].width;
    if (width != height)
      throw fail(fmt::format("face {} has {}x{} texels and is not square", kNames[i], width, height));
    if (width != first)
      throw fail(fmt::format("face {} has {}x{} texels, but face +X has {}x{}", kNames[i], width, height,
                             first, first));
  }
}

Texture make_cube_map(std::span<const image::Image8, 6> faces, image::Encoding encoding,
                      const Sampling& sampling) {
  check_cube_faces(faces);
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
