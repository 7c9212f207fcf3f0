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
        "all vertices lie at one point, {:.7g} {:.7g} {:.7g}, in 32-bit floats: nothing is visible; if the "
        "file has more digits, move the model to the origin and export it again",
        least.x, least.y, least.z);

  const glm::vec3 far = glm::max(glm::abs(box.least), glm::abs(box.greatest));
  const float farthest = std::max({far.x, far.y, far.z});
  const double step = double{farthest} - double{std::nextafter(farthest, 0.0F)};
  if (longest < 1024 * step)
    return fmt::format(
        "the model is {:.3g} long and lies {:.3g} from the origin, where 32-bit floats are {:.3g} apart: its "
        "shape is lost; move it to the origin and export it again",
        longest, farthest, step);

  double area = 0;  // twice that of all triangles in a box whose longest side is 1
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = of_triangle(mesh, mesh.positions, t);
    const glm::dvec3 origin = glm::dvec3(a) / longest;
    area += glm::length(glm::cross(glm::dvec3(b) / longest - origin, glm::dvec3(c) / longest - origin));
  }
  // A picture of 512x512 has some 1e5 pixels for such a box: a tenth of one.
  if (area >= 1e-6) return {};
  return fmt::format(
      "compared with the model's size of {:.3g} its triangles are points and lines: nothing is visible; is a "
      "vertex far off, or do all lie on one line?",
      longest);
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
