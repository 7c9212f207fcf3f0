// SPDX-License-Identifier: MIT
// The objects in the scene of lab 7. Nothing to do for you here.
#pragma once
#include <glm/vec4.hpp>

namespace texel::environment {

/// Centre and radius of the spheres in world space: one in front, the others farther and farther away.
inline constexpr glm::vec4 kSpheres[] = {{0, 0, 0, 1},
                                         {3.1F, -0.6F, -2.2F, 0.9F},
                                         {-4.6F, -0.6F, -7, 1.2F},
                                         {6.5F, 1.8F, -8, 1.2F},
                                         {-7, 8, -16, 2}};

}  // namespace texel::environment
