// SPDX-License-Identifier: MIT
#include "truth/basis.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

namespace texel::truth {

double angle(glm::dvec3 a, glm::dvec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

double angle_in_degrees(glm::dvec3 a, glm::dvec3 b) {
  return glm::degrees(angle(a, b));
}

double orthonormality(const glm::dmat3& m) {
  const glm::dmat3 gram = glm::transpose(m) * m;
  double largest = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(gram[i][j] - (i == j ? 1.0 : 0.0)));
  return largest;
}

double handedness(glm::dvec3 tangent, glm::dvec3 bitangent, glm::dvec3 normal) {
  const double volume = glm::dot(glm::cross(normal, tangent), bitangent);
  return static_cast<double>(volume > 0) - static_cast<double>(volume < 0);
}

glm::dvec3 normalized_derivative(glm::dvec3 v, glm::dvec3 dv) {
  return (dv - v * (glm::dot(v, dv) / glm::dot(v, v))) / glm::length(v);
}

}  // namespace texel::truth
