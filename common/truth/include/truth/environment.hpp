// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "truth/ray.hpp"

/// The background and the depth buffer of a perspective camera. Near and far: 0 < near < far; "distance" is
/// along the view axis, as the near and far planes are measured.
namespace texel::truth {

/// The unit direction in the world that is seen through a place of the picture (pixels from the lower left
/// corner). It does not depend on the near and far planes.
glm::dvec3 background_direction(const Camera& camera, glm::dvec2 window);

/// The same for a place in normalised device coordinates, -1..1.
glm::dvec3 background_direction_at_ndc(const Camera& camera, glm::dvec2 ndc);

/// The depth that the buffer holds, 0 at the near and 1 at the far plane: far (d - near) / (d (far - near)),
/// which is (z_ndc + 1) / 2.
double window_depth(double distance, double near, double far);

/// z_ndc, -1 at the near and 1 at the far plane.
double ndc_depth(double distance, double near, double far);

/// The distance at which the buffer holds this depth: near far / (far - depth (far - near)).
double distance_at_depth(double depth, double near, double far);

/// How much farther a point must lie to get another depth in a buffer of `bits` bits: the distance
/// that one unit of 1 / (2^bits - 1) means there. Infinite where the next depth lies beyond infinity. About
/// d^2 / near / 2^bits when far is large.
double depth_step(double distance, double near, double far, int bits = 24);

}  // namespace texel::truth
