// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>

#include "image/image.hpp"

namespace texel::gl {

/// Throws Error (exit 3), which names the face and where it is `from`, when the six faces +X -X +Y -Y +Z -Z
/// are not squares of one size: OpenGL would read such a cube map as black and say nothing.
void check_cube_faces(std::span<const image::Image8, 6> faces, const std::string& from = {});

}  // namespace texel::gl
