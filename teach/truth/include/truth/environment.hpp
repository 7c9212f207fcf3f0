// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "truth/ray.hpp"

/// The background of a perspective camera.
namespace texel::truth {

/// The unit direction in the world that is seen through a place of the picture (pixels from the lower left
/// corner). It does not depend on the near and far planes.
glm::dvec3 background_direction(const Camera& camera, glm::dvec2 window);

}  // namespace texel::truth
