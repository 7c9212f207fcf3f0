// SPDX-License-Identifier: MIT
#include "truth/texture.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace texel::truth {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

double level_of_detail(const TexcoordGradient& gradient, dvec2 size) {
  return std::log2(std::max(glm::length(gradient.dx * size), glm::length(gradient.dy * size)));
}

dvec4 QuadPicture::at(dvec2 window) const {
  const auto hit = hit_quad(object_ray(pixel_ray(camera, window).ray, world_from_object), half_size);
  return hit ? texture(texcoord_map.texcoord(hit->texcoord)) : background;
}

Placement tilted(double degrees) {
  const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
  return {.linear = {dvec3(1, 0, 0), dvec3(0, c, -s), dvec3(0, s, c)}};
}

}  // namespace texel::truth
