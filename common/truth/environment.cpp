// SPDX-License-Identifier: MIT
#include "truth/environment.hpp"

#include <cmath>
#include <limits>

namespace texel::truth {

glm::dvec3 background_direction(const Camera& camera, glm::dvec2 window) {
  return pixel_ray(camera, window).ray.direction;
}

glm::dvec3 background_direction_at_ndc(const Camera& camera, glm::dvec2 ndc) {
  return background_direction(camera, 0.5 * (ndc + 1.0) * glm::dvec2(camera.width, camera.height));
}

double window_depth(double distance, double near, double far) {
  return far * (distance - near) / (distance * (far - near));
}

double ndc_depth(double distance, double near, double far) {
  return 2 * window_depth(distance, near, far) - 1;
}

double distance_at_depth(double depth, double near, double far) {
  return near * far / (far - depth * (far - near));
}

double depth_step(double distance, double near, double far, int bits) {
  // d = near far / w with w = far - depth (far - near); a step lowers w, and the difference of the two
  // quotients is taken by hand, since subtracting them would leave nothing near the eye.
  const double w = near * far / distance;
  const double lower = w - (far - near) / (std::ldexp(1.0, bits) - 1);
  return lower > 0 ? distance * (w - lower) / lower : std::numeric_limits<double>::infinity();
}

}  // namespace texel::truth
