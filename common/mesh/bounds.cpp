// SPDX-License-Identifier: MIT
#include "mesh/bounds.hpp"

#include <fmt/format.h>

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

std::string lost_shape(const Mesh& mesh) {
  const Bounds box = bounds(mesh);
  const glm::dvec3 least(box.least), greatest(box.greatest), extent = greatest - least;
  const double longest = std::max({extent.x, extent.y, extent.z});
  if (longest == 0)
    return fmt::format(
        "all vertices lie at one point, {:.7g} {:.7g} {:.7g}, in 32-bit floats: nothing is visible; "
        "if the "
        "file has more digits, move the model to the origin and export it again",
        least.x, least.y, least.z);

  float farthest = 0;
  for (int axis = 0; axis < 3; ++axis)
    farthest = std::max({farthest, std::abs(box.least[axis]), std::abs(box.greatest[axis])});
  const double step = double{farthest} - double{std::nextafter(farthest, 0.0f)};
  if (longest < 1024 * step)
    return fmt::format(
        "the model is {:.3g} long and lies {:.3g} from the origin, where 32-bit floats are {:.3g} apart: its "
        "shape is "
        "lost; move it to the origin and export it again",
        longest, farthest, step);

  double area = 0;  // twice that of all triangles in a box whose longest side is 1
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const auto at = [&](std::size_t k) { return glm::dvec3(mesh.positions[mesh.indices[i + k]]) / longest; };
    area += glm::length(glm::cross(at(1) - at(0), at(2) - at(0)));
  }
  // A picture of 512x512 has some 1e5 pixels for such a box: a tenth of one.
  if (area < 1e-6)
    return fmt::format(
        "compared with the model's size of {:.3g} its triangles are points and lines: nothing is visible; is "
        "a vertex "
        "far "
        "off, or do all lie on one line?",
        longest);
  return {};
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
