// SPDX-License-Identifier: MIT
#include "truth/relief.hpp"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

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

dvec3 displaced_normal(const SurfacePoint& point, double height, dvec2 height_gradient, double strength) {
  const dvec3 ds = point.ds + strength * (height_gradient.s * point.normal + height * point.normal_ds);
  const dvec3 dt = point.dt + strength * (height_gradient.t * point.normal + height * point.normal_dt);
  const double side = glm::dot(point.normal, glm::cross(point.ds, point.dt)) < 0 ? -1 : 1;
  return glm::normalize(side * glm::cross(ds, dt));
}

dvec3 mapped_normal(const Frame& frame, dvec3 texel) {
  return glm::normalize(texel.x * frame.tangent + texel.y * frame.bitangent + texel.z * frame.normal);
}

dvec3 baked_texel(const Frame& frame, dvec3 normal) {
  return glm::normalize(glm::inverse(glm::dmat3(frame.tangent, frame.bitangent, frame.normal)) * normal);
}

}  // namespace texel::truth
