// SPDX-License-Identifier: MIT
#include "truth/environment.hpp"

namespace texel::truth {

glm::dvec3 background_direction(const Camera& camera, glm::dvec2 window) {
  return pixel_ray(camera, window).ray.direction;
}

}  // namespace texel::truth
