// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "gl/texture.hpp"

/// What lab 1 does by hand: uploading pictures into textures, and binding textures to units.
namespace texel::gl {

/// Binds a texture to the active unit until the end of the scope. Making a texture then disturbs no unit: a
/// new texture would else replace the one that the next draw call reads.
class ScopedBinding {
 public:
  ScopedBinding(GLenum target, GLuint texture);
  ScopedBinding(GLenum target, const Texture& texture) : ScopedBinding(target, texture.id()) {}
  ~ScopedBinding() { glBindTexture(target_, static_cast<GLuint>(before_)); }
  ScopedBinding& operator=(ScopedBinding&&) = delete;

 private:
  GLenum target_;
  GLint before_;
};

/// How many units there are, over all stages.
GLint texture_units();

/// As in a new context: no unit has a texture, unit 0 is active, and rows begin at multiples of four bytes.
/// What one picture bound does not help or spoil the next.
void unbind_textures();

/// Uploads one level of the bound texture; rows of any length are tightly packed.
void upload_level(GLenum target, int level, const image::Image8& image, image::Encoding encoding);

/// A 2D texture with its mipmaps (image/mipmaps.hpp: averaged in linear light). No unit's binding is changed.
Texture make_texture_2d(const image::Image8& image, image::Encoding encoding, const Sampling& sampling = {});

/// A cube map of six faces in OpenGL's order +X -X +Y -Y +Z -Z, squares of one size, with mipmaps. Row 0 of
/// each image is t = 0, which the specification draws at the top.
Texture make_cube_map(std::span<const image::Image8, 6> faces, image::Encoding encoding,
                      const Sampling& sampling);

/// Binds a texture to a unit, where a sampler uniform of the same number reads it.
void bind(int unit, GLenum target, const Texture& texture);

}  // namespace texel::gl
