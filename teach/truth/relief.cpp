// SPDX-License-Identifier: MIT
#include "truth/relief.hpp"

#include <glm/geometric.hpp>

namespace texel::truth {

using glm::dvec2;
using glm::dvec3;

dvec3 surface_gradient(const SurfacePoint& point, dvec2 height_gradient) {
  const dvec3 along = height_gradient.s * glm::cross(point.dt, point.normal) +
                      height_gradient.t * glm::cross(point.normal, point.ds);
  return along / glm::dot(point.normal, glm::cross(point.ds, point.dt));
}

dvec3 relief_normal(const SurfacePoint& point, dvec2 height_gradient, double strength) {
  return glm::normalize(point.normal - strength * surface_gradient(point, height_gradient));
}

dvec3 mapped_normal(const Frame& frame, dvec3 texel) {
  return glm::normalize(texel.x * frame.tangent + texel.y * frame.bitangent + texel.z * frame.normal);
}

}  // namespace texel::truth
