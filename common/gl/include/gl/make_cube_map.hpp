// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "gl/texture.hpp"

namespace texel::gl {

/// A cube map of six faces in OpenGL's order +X -X +Y -Y +Z -Z, with mipmaps. Row 0 of each image is t = 0,
/// which the specification draws at the top. Throws Error when the faces are not squares of one size.
Texture make_cube_map(std::span<const image::Image8, 6> faces, image::Encoding encoding,
                      const Sampling& sampling);

}  // namespace texel::gl
