// SPDX-License-Identifier: MIT
#pragma once
#include "gl/target.hpp"

namespace texel::gl {

/// GL_SUBPIXEL_BITS: how finely the browser's renderer rounds the places of vertices.
int subpixel_bits();
/// In the browser, where that is coarse: what is drawn from now on is moved by this part of a pixel before
/// it is rounded, and back afterwards (es_source.hpp).
void set_shift(float x, float y);

/// While it lives, pictures are for the eye alone, and are drawn sooner by a renderer that rounds coarsely:
/// such ones draw with the processor. What is interpolated is not moved back. Shaders encode their colours,
/// once a pixel in place of once a sample, for targets of kind().
class Preview {
 public:
  /// If it is not wanted, nothing changes.
  explicit Preview(bool wanted);
  ~Preview();
  Preview& operator=(Preview&&) = delete;
  [[nodiscard]] static Target::Kind kind();
};
}  // namespace texel::gl
