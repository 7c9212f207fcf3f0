// SPDX-License-Identifier: MIT
#include "gl/texture.hpp"

#include <algorithm>

namespace texel::gl {

Format format_of(int channels, image::Encoding encoding) {
  const bool srgb = encoding == image::Encoding::srgb;
  switch (channels) {
    case 1:
      return {GL_R8, GL_RED};
    case 2:
      return {GL_RG8, GL_RG};
    case 3:
      return {srgb ? GLenum{GL_SRGB8} : GLenum{GL_RGB8}, GL_RGB};
    default:
      return {srgb ? GLenum{GL_SRGB8_ALPHA8} : GLenum{GL_RGBA8}, GL_RGBA};
  }
}

image::Image8 expand_grey(const image::Image8& image) {
  if (image.channels > 2) return image;
  image::Image8 color(image.width, image.height, image.channels + 2);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < 3; ++c) color.at(x, y, c) = image.at(x, y);
      if (image.channels == 2) color.at(x, y, 3) = image.at(x, y, 1);
    }
  return color;
}

void set_sampling(GLenum target, const Sampling& sampling) {
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(sampling.minify));
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(sampling.magnify));
  glTexParameteri(target, GL_TEXTURE_WRAP_S, static_cast<GLint>(sampling.wrap_s));
  glTexParameteri(target, GL_TEXTURE_WRAP_T, static_cast<GLint>(sampling.wrap_t));
  if (GLAD_GL_EXT_texture_filter_anisotropic != 0) {
    float most = 1;
    glGetFloatv(GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT, &most);
    glTexParameterf(target, GL_TEXTURE_MAX_ANISOTROPY_EXT, std::clamp(sampling.anisotropy, 1.0F, most));
  }
}

}  // namespace texel::gl
