// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <glm/vec3.hpp>

#include "image/cube_faces.hpp"

/// Cube maps as functions of the direction.
namespace texel::procedural {

inline constexpr std::array faces{image::Face::positive_x, image::Face::negative_x, image::Face::positive_y,
                                  image::Face::negative_y, image::Face::positive_z, image::Face::negative_z};

/// The unit direction that looks up the coordinate (s, t) of a face.
glm::dvec3 direction(image::Face face, double s, double t);

/// Linear-light RGB in 0..1 that changes smoothly over the whole sphere, without a seam at any edge.
glm::dvec3 smooth_color(glm::dvec3 direction);

/// Linear-light RGB of the labelled cube: each face has its own colour, name, word and arrows along +u (s of
/// the table) and +v (t of the table). The writing reads the right way round from inside the cube, with +y
/// up; the faces +y and -y as seen when the head is tilted back or forward from looking along -z. `direction`
/// has any length but zero.
glm::dvec3 labelled_color(glm::dvec3 direction);

}  // namespace texel::procedural
