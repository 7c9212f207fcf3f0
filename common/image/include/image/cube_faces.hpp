// SPDX-License-Identifier: MIT
#pragma once
#include <glm/mat3x3.hpp>

/// Source: OpenGL 3.3 core specification, table 3.17 (sc, tc, ma).
namespace texel::image {

/// The faces of a cube map in OpenGL's order, so that GL_TEXTURE_CUBE_MAP_POSITIVE_X + face is the target.
enum class Face { positive_x, negative_x, positive_y, negative_y, positive_z, negative_z };

/// As columns, the directions in which s, t and the major axis of a face grow: the specification's sc, tc and
/// ma are a direction's components along them. t grows from the row that is uploaded first.
const glm::dmat3& axes(Face face);

/// The face and coordinate that a direction of any length (not zero) looks up. On a tie, x goes before y and
/// y before z.
struct FaceCoordinate {
  Face face;
  double s, t;  ///< 0 to 1
};
FaceCoordinate face_coordinate(const glm::dvec3& direction);

}  // namespace texel::image
