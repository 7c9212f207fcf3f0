// SPDX-License-Identifier: MIT
// Directions at which frames, angles and cube faces are hard.
#pragma once
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

namespace texel::test {

/// `count` directions on a cone of `radius` (tangent of the angle) around the axis (0, 1 or 2) of this sign.
/// Half of them are rounded from double, half made unit in floats, as a shader does it.
inline void add_cone(std::vector<glm::vec3>& directions, int axis, double sign, double radius, int count) {
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (i / 2) / (count / 2);
    glm::dvec3 v(0);
    v[axis] = sign;
    v[(axis + 1) % 3] = radius * std::cos(angle);
    v[(axis + 2) % 3] = radius * std::sin(angle);
    directions.push_back(i % 2 == 0 ? glm::vec3(glm::normalize(v)) : glm::normalize(glm::vec3(v)));
  }
}

/// Unit vectors in floats: all axes, cones of 1e-24 to 0.1 around them, the ties between components, signed
/// zeros, and the whole sphere evenly (a spiral).
inline std::vector<glm::vec3> hard_directions() {
  std::vector<glm::vec3> result;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {-1.0, 1.0})
      for (int i = 0; i <= 230; ++i) add_cone(result, axis, sign, std::pow(10.0, -24 + 0.1 * i), 64);
  for (const float x : {-1.0F, -0.0F, 0.0F, 1.0F})
    for (const float y : {-1.0F, -0.0F, 0.0F, 1.0F})
      for (const float z : {-1.0F, -1e-12F, -0.0F, 0.0F, 1e-12F, 1.0F})
        if (std::abs(x) + std::abs(y) + std::abs(z) >= 1)
          result.push_back(glm::normalize(glm::vec3(x, y, z)));
  constexpr int kSpiral = 50000;
  for (int i = 0; i < kSpiral; ++i) {
    const double y = 1 - 2 * (i + 0.5) / kSpiral, r = std::sqrt(1 - y * y), angle = i * 2.39996322972865;
    result.push_back(glm::vec3(glm::dvec3(r * std::cos(angle), y, r * std::sin(angle))));
  }
  return result;
}

}  // namespace texel::test
