// SPDX-License-Identifier: MIT
#include "mesh/polygon.hpp"

#include "mesh/vectors.hpp"
#include "newell.hpp"

namespace texel::mesh {
namespace {

/// The corners in the polygon's plane, seen from the side from which they run counter-clockwise.
std::vector<glm::dvec2> flatten(std::span<const glm::vec3> corners, const glm::vec3& normal) {
  const glm::dvec3 x(any_orthogonal(normal));
  const glm::dvec3 y = glm::cross(glm::dvec3(normal), x);
  std::vector<glm::dvec2> flat;
  flat.reserve(corners.size());
  for (const glm::vec3& corner : corners) {
    const glm::dvec3 p = glm::dvec3(corner) - glm::dvec3(corners[0]);
    flat.emplace_back(glm::dot(p, x), glm::dot(p, y));
  }
  return flat;
}

/// Whether each triangle of the fan turns the right way: then the fan covers a simple polygon exactly once.
bool fan_fits(const std::vector<glm::dvec2>& flat) {
  for (std::size_t i = 1; i + 1 < flat.size(); ++i)
    if (area(flat[0], flat[i], flat[i + 1]) <= 0.0) return false;
  return true;
}

/// Whether the fan fits by so much that rounding cannot matter: seen along the polygon's `normal` (of any
/// length), each triangle a b of the fan has more than a thousandth of the area |a| |b| / 2. True for nearly
/// all polygons that are drawn, at a third of the cost of flattening them.
bool fan_fits_clearly(std::span<const glm::vec3> corners, const glm::dvec3& normal) {
  const glm::dvec3 origin(corners[0]);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const glm::dvec3 a = glm::dvec3(corners[i]) - origin, b = glm::dvec3(corners[i + 1]) - origin;
    const double along = glm::dot(glm::cross(a, b), normal);
    const bool clear =
        along > 0.0 && along * along > 1e-6 * glm::dot(a, a) * glm::dot(b, b) * glm::dot(normal, normal);
    if (!clear) return false;
  }
  return true;
}

}  // namespace

glm::dvec3 newell_normal(std::span<const glm::vec3> corners) {
  const glm::dvec3 origin(corners[0]);  // relative to a corner: far from the origin no digits are lost
  glm::dvec3 normal(0.0);
  for (std::size_t i = 0; i < corners.size(); ++i)
    normal +=
        glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[(i + 1) % corners.size()]) - origin);
  return normal;
}

void fan(std::size_t corners, std::vector<Triangle>& triangles) {
  for (std::uint32_t i = 1; i + 1 < corners; ++i) triangles.push_back({0, i, i + 1});
}

bool holds_a_corner(const std::vector<glm::dvec2>& flat, const std::vector<std::uint32_t>& rest,
                    const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  for (const std::uint32_t i : rest) {
    const glm::dvec2& p = flat[i];
    if (area(a, b, p) >= 0.0 && area(b, c, p) >= 0.0 && area(c, a, p) >= 0.0 && p != a && p != b && p != c)
      return true;
  }
  return false;
}

bool triangulate(std::span<const glm::vec3> corners, std::vector<Triangle>& triangles) {
  triangles.clear();
  const glm::dvec3 newell = newell_normal(corners);
  const glm::vec3 normal = unit_or_zero(newell);
  bool fits = fan_fits_clearly(corners, newell);
  if (!fits && !is_zero(normal)) {
    const std::vector<glm::dvec2> flat = flatten(corners, normal);
    fits = fan_fits(flat);
    if (!fits && corners.size() <= max_clipped_corners) return clip_ears(flat, triangles);
  }
  fan(corners.size(), triangles);
  return fits;
}

}  // namespace texel::mesh
