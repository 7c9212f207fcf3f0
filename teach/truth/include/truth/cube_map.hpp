// SPDX-License-Identifier: MIT
#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "image/cube_faces.hpp"
#include "truth/ray.hpp"

/// Lookups by a direction. image/cube_faces.hpp has the table between directions and the faces' coordinates,
/// in double, from which the cube maps of the course are made; here are the derivatives.
namespace texel::truth {

/// A direction's change from pixel to pixel; any length, per pixel.
struct DirectionGradient {
  glm::dvec3 dx, dy;
};

/// How the coordinate (s, t) changes on the face that the direction (of any length) looks up, by the quotient
/// rule. A neighbour on another face counts as lying in the plane of this one: edges are invisible.
TexcoordGradient face_gradient(glm::dvec3 direction, const DirectionGradient& change);

/// The level of detail of a lookup in a cube map with faces of `size` texels: log2 of the longer gradient in
/// texels. Source: OpenGL 3.3 core specification, "Scale Factor and Level of Detail".
double cube_level_of_detail(glm::dvec3 direction, const DirectionGradient& change, double size);

/// The worksheet's coordinate of a direction of any length: u = atan(x, z) / -2 pi, v = the angle from +y /
/// pi. u is 0 at +z, falls towards +x and jumps from -1/2 to 1/2 at -z. On the y axis, u = 0.
glm::dvec2 worksheet_texcoord(glm::dvec3 direction);

/// Its derivatives in closed form: there is no jump in them. Not finite on the y axis itself.
TexcoordGradient worksheet_gradient(glm::dvec3 direction, const DirectionGradient& change);

}  // namespace texel::truth
