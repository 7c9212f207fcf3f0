// SPDX-License-Identifier: MIT
#pragma once
#include "gl/upload.hpp"

namespace texel::window {

/// A picture for ImGui: its bytes as they are, enlarged to squares.
inline gl::Texture picture_texture(const image::Image8& picture, GLenum wrap_s = GL_CLAMP_TO_EDGE,
                                   GLenum wrap_t = GL_CLAMP_TO_EDGE) {
  gl::Sampling sampling;
  sampling.minify = GL_LINEAR, sampling.magnify = GL_NEAREST;
  sampling.wrap_s = wrap_s, sampling.wrap_t = wrap_t;
  return gl::make_texture_2d(picture, image::Encoding::linear, sampling);
}

}  // namespace texel::window
