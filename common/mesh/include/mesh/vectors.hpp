// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace texel::mesh {

/// `v` at unit length, or zero where it has no direction (zero or not finite). In double: lengths of
/// 1e-30 and 1e30 do not vanish or overflow when squared.
inline glm::vec3 unit_or_zero(const glm::dvec3& v) {
  const double squared = glm::dot(v, v);
  return squared > 0.0 && std::isfinite(squared) ? glm::vec3(v / std::sqrt(squared)) : glm::vec3(0.0F);
}

inline bool is_zero(const glm::vec3& v) {
  return v == glm::vec3(0.0F);
}

/// The angle between two directions in radians, 0..pi. Exact also for slivers, unlike the arc cosine. 0
/// when one is zero.
inline double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// The triangle's inner angles at its corners, in radians.
inline std::array<double, 3> corner_angles(const std::array<glm::vec3, 3>& p) {
  const glm::dvec3 a(p[0]), b(p[1]), c(p[2]);
  return {angle_between(b - a, c - a), angle_between(c - b, a - b), angle_between(a - c, b - c)};
}

/// Some unit vector orthogonal to the unit vector `n`: the cross product with the axis that is farthest from
/// it, and is never near zero.
inline glm::vec3 any_orthogonal(const glm::vec3& n) {
  const glm::vec3 size = glm::abs(n);
  const glm::vec3 axis = size.x <= size.y && size.x <= size.z ? glm::vec3(1.0F, 0.0F, 0.0F)
                         : size.y <= size.z                   ? glm::vec3(0.0F, 1.0F, 0.0F)
                                                              : glm::vec3(0.0F, 0.0F, 1.0F);
  const glm::vec3 t = unit_or_zero(glm::cross(glm::dvec3(axis), glm::dvec3(n)));
  return is_zero(t) ? axis : t;
}

/// `v` without its part along `n`.
inline glm::dvec3 orthogonal_part(const glm::dvec3& v, const glm::dvec3& n) {
  return v - n * (glm::dot(v, n) / glm::dot(n, n));
}

/// Whether a unit vector or zero lies along the unit normal `n`: nothing but rounding is left of it in the
/// plane.
inline bool is_along(const glm::dvec3& v, const glm::dvec3& n) {
  return !(glm::length(orthogonal_part(v, n)) > 1e-6);
}

}  // namespace texel::mesh
