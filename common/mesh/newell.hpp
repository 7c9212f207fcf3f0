// SPDX-License-Identifier: MIT
// Only for this folder: lab 4 asks for a triangle's normal, and nobody should find it ready to be called.
#pragma once
#include <array>
#include <glm/glm.hpp>
#include <span>

#include "mesh/vectors.hpp"

namespace texel::mesh {

/// Newell's normal: its length is twice the area, and it is right for concave and slightly bent polygons.
glm::dvec3 newell_normal(std::span<const glm::vec3> corners);

/// The unit normal of the triangle a b c as a polygon, on the side from which it runs counter-clockwise; zero
/// when it has no area.
inline glm::vec3 newell_unit(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  return unit_or_zero(newell_normal(std::array{a, b, c}));
}

}  // namespace texel::mesh
