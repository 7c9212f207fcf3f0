// SPDX-License-Identifier: MIT
#include "truth/basis.hpp"

#include <glm/geometric.hpp>

namespace texel::truth {

double handedness(glm::dvec3 tangent, glm::dvec3 bitangent, glm::dvec3 normal) {
  const double volume = glm::dot(glm::cross(normal, tangent), bitangent);
  return static_cast<double>(volume > 0) - static_cast<double>(volume < 0);
}

glm::dvec3 normalized_derivative(glm::dvec3 v, glm::dvec3 dv) {
  return (dv - v * (glm::dot(v, dv) / glm::dot(v, v))) / glm::length(v);
}

}  // namespace texel::truth
