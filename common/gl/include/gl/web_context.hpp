// SPDX-License-Identifier: MIT
#pragma once

namespace texel::gl {

/// GL_SUBPIXEL_BITS: how finely the browser's renderer rounds the places of vertices.
int subpixel_bits();
/// In the browser, where that is coarse: what is drawn from now on is moved by this part of a pixel before
/// it is rounded, and back afterwards (gl/es_source.hpp).
void set_shift(float x, float y);

}  // namespace texel::gl
