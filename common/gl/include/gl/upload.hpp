// SPDX-License-Identifier: MIT
#pragma once
#include "gl/texture.hpp"

/// What lab 1 does by hand: pictures on their way into textures, and textures into units.
namespace texel::gl {

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

/// A 2D texture with its mipmaps (image/mipmaps.hpp: averaged in linear light). No unit's binding is changed.
Texture make_texture_2d(const image::Image8& image, image::Encoding encoding, const Sampling& sampling = {});

/// Binds a texture to a unit, where a sampler uniform of the same number reads it.
void bind(int unit, GLenum target, const Texture& texture);

}  // namespace texel::gl
