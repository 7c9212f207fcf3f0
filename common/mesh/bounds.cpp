// SPDX-License-Identifier: MIT
#include "mesh/bounds.hpp"

#include <algorithm>
#include <cmath>

namespace texel::mesh {

Bounds bounds(const Mesh& mesh) {
  if (mesh.positions.empty()) return {};
  Bounds box{mesh.positions[0], mesh.positions[0]};
  for (const glm::vec3& position : mesh.positions) {
    box.least = glm::min(box.least, position);
    box.greatest = glm::max(box.greatest, position);
  }
  return box;
}

void normalize_to_unit(Mesh& mesh) {
  const Bounds box = bounds(mesh);
  const glm::dvec3 center = 0.5 * (glm::dvec3(box.least) + glm::dvec3(box.greatest));
  double squared_radius = 0.0;
  for (const glm::vec3& position : mesh.positions) {
    const glm::dvec3 offset = glm::dvec3(position) - center;
    squared_radius = std::max(squared_radius, glm::dot(offset, offset));
  }
  const double scale = squared_radius > 0.0 ? 1.0 / std::sqrt(squared_radius) : 1.0;
  for (glm::vec3& position : mesh.positions) position = glm::vec3(scale * (glm::dvec3(position) - center));
}

}  // namespace texel::mesh
