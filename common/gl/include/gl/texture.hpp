// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>

#include "gl/objects.hpp"
#include "image/image.hpp"

namespace texel::gl {

/// How a texture is read between and beyond its texels.
struct Sampling {
  GLenum minify = GL_LINEAR_MIPMAP_LINEAR;
  GLenum magnify = GL_LINEAR;
  GLenum wrap_s = GL_REPEAT;
  GLenum wrap_t = GL_REPEAT;
  float anisotropy = 1;  ///< at most what the driver offers; 1 is off
};

/// The formats in which an image of so many channels lies in memory and on the GPU.
struct Format {
  GLenum internal;  ///< GL_SRGB8, GL_RG8, …
  GLenum external;  ///< GL_RED, GL_RG, GL_RGB, GL_RGBA
};
Format format_of(int channels, image::Encoding encoding);

/// OpenGL has sRGB formats for RGB and RGBA only: grey colour pictures become RGB, grey and alpha RGBA.
image::Image8 expand_grey(const image::Image8& image);

/// Binds a texture to the active unit for the length of a scope, so that making one disturbs no unit: a
/// texture that is bound while it is made would else take the place of the one that the next draw call reads.
class ScopedBinding {
 public:
  ScopedBinding(GLenum target, const Texture& texture);
  ~ScopedBinding();
  ScopedBinding(const ScopedBinding&) = delete;
  ScopedBinding& operator=(const ScopedBinding&) = delete;

 private:
  GLenum target_;
  GLint before_ = 0;
};

/// Uploads one level of the bound texture; rows are tightly packed, whatever their length.
void upload_level(GLenum target, int level, const image::Image8& image, image::Encoding encoding);

/// Sampling state of the texture that is bound to `target`.
void set_sampling(GLenum target, const Sampling& sampling);

/// A 2D texture with its mipmaps (image/mipmaps.hpp: averaged in linear light). No
/// unit's binding is changed.
Texture make_texture_2d(const image::Image8& image, image::Encoding encoding, const Sampling& sampling = {});

/// A cube map of six faces in OpenGL's order +X -X +Y -Y +Z -Z, with mipmaps. Row 0 of each image is t = 0,
/// which the specification draws at the top. Throws Error when the faces are not squares of one size.
Texture make_cube_map(std::span<const image::Image8, 6> faces, image::Encoding encoding,
                      const Sampling& sampling);

/// Binds a texture to a unit, where a sampler uniform of the same number reads it.
void bind(int unit, GLenum target, const Texture& texture);

}  // namespace texel::gl
