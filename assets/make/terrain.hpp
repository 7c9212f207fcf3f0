// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec3.hpp>
#include <vector>

namespace texel::assets {

/// Hills and mountains around the origin, flat within 300 m: heights in metres on a grid, so that a ray can
/// be marched over them quickly.
class Terrain {
 public:
  Terrain();

  /// Height above y = 0, at x and z within +-extent; 0 outside.
  [[nodiscard]] double height(double x, double z) const;
  /// The unit normal there.
  [[nodiscard]] glm::dvec3 normal(double x, double z) const;
  /// How far along the unit direction the ground is met, or a negative number.
  [[nodiscard]] double intersect(glm::dvec3 origin, glm::dvec3 direction) const;

 private:
  static constexpr int size = 1024;
  static constexpr double extent = 6000, cell = 2 * extent / (size - 1);
  std::vector<float> heights_;
};

}  // namespace texel::assets
