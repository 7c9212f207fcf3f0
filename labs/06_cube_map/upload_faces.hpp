// SPDX-License-Identifier: MIT
#pragma once
#include <array>

#include "image/image.hpp"

namespace texel::cube_map {

/// Uploads six pictures, +X -X +Y -Y +Z -Z, into the bound cube map, with smaller levels if it is
/// `mipmapped`. The specification sees each face from outside the cube, top row first. 2D textures begin at
/// the bottom.
void upload_faces(const std::array<image::Image8, 6>& faces, bool mipmapped);

}  // namespace texel::cube_map
