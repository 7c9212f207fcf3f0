// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "truth/ray.hpp"

namespace texel::truth {

/// A texture without texels: the colour at a texture coordinate, linear-light RGB and alpha.
using TextureFunction = std::function<glm::dvec4(glm::dvec2 texcoord)>;

/// The level of detail of an isotropic mipmap lookup: log2 of the longer of the two gradients, measured in
/// texels of a base level of `size` texels. Not clamped; minus infinity if both are 0. Source: the same,
/// "Scale Factor and Level of Detail".
double level_of_detail(const TexcoordGradient& gradient, glm::dvec2 size);

/// The textured square of lab 1 seen by a camera.
struct QuadPicture {
  Camera camera;
  Placement world_from_object;  ///< such as tilted() below
  double half_size = 0.7;
  TexcoordMap texcoord_map;  ///< such as texture scale and offset
  TextureFunction texture;
  glm::dvec4 background{0};

  /// The colour that the ray through a place of the picture meets.
  [[nodiscard]] glm::dvec4 at(glm::dvec2 window) const;
};

/// Turned about the x axis by `degrees`, the top leaning away from the eye: lab 1's tilt.
Placement tilted(double degrees);

}  // namespace texel::truth
