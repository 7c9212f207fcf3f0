// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace texel::procedural {

/// The faces of a cube map in OpenGL's order, so that GL_TEXTURE_CUBE_MAP_POSITIVE_X + face is the target.
enum class Face { positive_x, negative_x, positive_y, negative_y, positive_z, negative_z };
inline constexpr std::array<Face, 6> faces{Face::positive_x, Face::negative_x, Face::positive_y,
                                           Face::negative_y, Face::positive_z, Face::negative_z};

/// "px", "nx", "py", "ny", "pz" or "nz": the file's name.
const char* file_name(Face face);

/// The unit direction that looks up the coordinate (s, t) of a face; s and t in 0..1, t = 0 at the row that
/// is uploaded first. Source: OpenGL 3.3 core specification, table 3.17 (sc, tc, ma), solved for the
/// direction.
glm::dvec3 direction(Face face, double s, double t);

/// The face and coordinate that a direction of any length (not zero) looks up: the same table. On a tie, x
/// goes before y and y before z.
struct FaceCoordinate {
  Face face;
  double s, t;
};
FaceCoordinate face_coordinate(glm::dvec3 direction);

/// Linear-light RGB in 0..1 that changes smoothly over the whole sphere, without a seam at any edge.
glm::dvec3 smooth_color(glm::dvec3 direction);

/// Linear-light RGB of the labelled cube: each face has its own colour, name, word and arrows along +u (s of
/// the table) and +v (t of the table). The writing reads the right way round from inside the cube, with +y
/// up; the faces +y and -y as seen when the head is tilted back or forward from looking along -z. `direction`
/// has any length but zero.
glm::dvec3 labelled_color(glm::dvec3 direction);

}  // namespace texel::procedural
