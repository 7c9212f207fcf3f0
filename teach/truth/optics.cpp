// SPDX-License-Identifier: MIT
#include "truth/optics.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace texel::truth {

using glm::dvec3;

dvec3 reflected(dvec3 incident, dvec3 normal) {
  return incident - 2 * glm::dot(normal, incident) * normal;
}

std::optional<dvec3> refracted(dvec3 incident, dvec3 normal, double n_from, double n_to) {
  // The part of the ray along the boundary is scaled by the indices; the rest of the unit length goes on. The
  // squared cosine behind is 1 - eta^2 (1 - across^2): in this form a sum of positive terms into a denser
  // medium, exact at grazing incidence too.
  const double across = glm::dot(incident, normal), eta = n_from / n_to;
  const double rest = (1 - eta) * (1 + eta) + eta * eta * across * across;
  if (rest < 0) return std::nullopt;
  const dvec3 along = eta * (incident - across * normal);
  return along + std::copysign(std::sqrt(rest), across) * normal;
}

double reflectance(dvec3 incident, dvec3 normal, double n_from, double n_to) {
  const auto refracted_ray = refracted(incident, normal, n_from, n_to);
  if (!refracted_ray) return 1;
  const double here = std::abs(glm::dot(incident, normal)),
               beyond = std::abs(glm::dot(*refracted_ray, normal));
  if (here + beyond == 0) return 1;  // along a boundary between equal media
  const auto part = [](double a, double b) { return (a - b) * (a - b) / ((a + b) * (a + b)); };
  return (part(n_from * here, n_to * beyond) + part(n_to * here, n_from * beyond)) / 2;
}

}  // namespace texel::truth
