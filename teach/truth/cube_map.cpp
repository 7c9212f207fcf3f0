// SPDX-License-Identifier: MIT
#include "truth/cube_map.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "truth/texture.hpp"

namespace texel::truth {

using glm::dvec2;
using glm::dvec3;

namespace {

/// f of both steps.
template <class Function>
TexcoordGradient each(const DirectionGradient& change, Function f) {
  return {f(change.dx), f(change.dy)};
}

}  // namespace

TexcoordGradient face_gradient(dvec3 direction, const DirectionGradient& change) {
  const glm::dmat3& axes = image::axes(image::face_coordinate(direction).face);
  const dvec3 s_axis = axes[0], t_axis = axes[1], major = axes[2];
  const double depth = glm::dot(direction, major);
  const dvec2 place(glm::dot(direction, s_axis), glm::dot(direction, t_axis));
  return each(change, [&](dvec3 step) {
    const dvec2 moved(glm::dot(step, s_axis), glm::dot(step, t_axis));
    return 0.5 * (moved - place * (glm::dot(step, major) / depth)) / depth;
  });
}

double cube_level_of_detail(dvec3 direction, const DirectionGradient& change, double size) {
  return level_of_detail(face_gradient(direction, change), dvec2(size));
}

dvec2 worksheet_texcoord(dvec3 d) {
  return {std::atan2(d.x, d.z) / (-2 * std::numbers::pi),
          std::atan2(std::hypot(d.x, d.z), d.y) / std::numbers::pi};
}

TexcoordGradient worksheet_gradient(dvec3 d, const DirectionGradient& change) {
  const double from_axis = std::hypot(d.x, d.z), squared = d.x * d.x + d.z * d.z;
  return each(change, [&](dvec3 step) {
    const double outward = (d.x * step.x + d.z * step.z) / from_axis;
    return dvec2((d.z * step.x - d.x * step.z) / (-2 * std::numbers::pi * squared),
                 (d.y * outward - from_axis * step.y) / (std::numbers::pi * (squared + d.y * d.y)));
  });
}

}  // namespace texel::truth
