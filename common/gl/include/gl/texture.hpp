// SPDX-License-Identifier: MIT
#pragma once
#include "gl/objects.hpp"
#include "image/image.hpp"

namespace texel::gl {

/// OpenGL's filters, in the order of the labs' parameter `minify`. The first two also magnify; the others
/// read smaller levels.
inline constexpr GLenum kFilters[] = {GL_NEAREST,
                                      GL_LINEAR,
                                      GL_NEAREST_MIPMAP_NEAREST,
                                      GL_LINEAR_MIPMAP_NEAREST,
                                      GL_NEAREST_MIPMAP_LINEAR,
                                      GL_LINEAR_MIPMAP_LINEAR};

/// How a texture is read between and beyond its texels.
struct Sampling {
  GLenum minify = GL_LINEAR_MIPMAP_LINEAR;
  GLenum magnify = GL_LINEAR;
  GLenum wrap_s = GL_REPEAT;
  GLenum wrap_t = GL_REPEAT;
  float anisotropy = 1;  ///< at most what the driver offers; 1 is off
};

/// The formats in memory and on the GPU of an image with this many channels.
struct Format {
  GLenum internal;  ///< GL_SRGB8, GL_RG8, …
  GLenum external;  ///< GL_RED, GL_RG, GL_RGB, GL_RGBA
};
Format format_of(int channels, image::Encoding encoding);

/// OpenGL has sRGB formats for RGB and RGBA only: grey colour pictures become RGB, grey and alpha RGBA.
image::Image8 expand_gray(const image::Image8& image);

/// Sampling state of the texture that is bound to `target`.
void set_sampling(GLenum target, const Sampling& sampling);
/// A 2D texture's as of a new one: what one picture sets does not help the next. No unit's binding changes.
void forget_sampling(const Texture& texture);

}  // namespace texel::gl
