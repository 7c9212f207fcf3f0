// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>

#include "mesh/mesh.hpp"
#include "mesh/obj.hpp"

namespace texel::mesh {

/// How a triangle is weighted in the normal of its corner.
enum class Weighting {
  area,   ///< by its area (Gouraud's plain sum of cross products)
  angle,  ///< by the corner's angle (Thuermer and Wuethrich 1998): how faces are cut does not matter
};

/// The normal of a vertex whose triangles have no area.
inline constexpr glm::vec3 fallback_normal{0.0F, 1.0F, 0.0F};

/// How a triangle's normal is found: a unit vector on the side from which a b c run counter-clockwise; zero
/// when the triangle has no area. Lab 4 teaches one; where none is given, the triangle is taken as a polygon
/// (Newell's formula).
using FaceNormal = glm::vec3 (*)(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Gives every triangle its face normal; vertices that triangles of different normals share are duplicated.
/// Tangents are emptied. Triangles without area take fallback_normal.
void flat_normals(Mesh& mesh, FaceNormal face_normal = nullptr);

/// Gives every vertex the weighted mean of the normals of all triangles at its position. So vertices
/// that are split for their texture coordinates stay smooth. Triangles without area add nothing. Tangents
/// are emptied. Expected linear time.
void smooth_normals(Mesh& mesh, Weighting weighting, FaceNormal face_normal = nullptr);

/// Gives a normal to every corner of an OBJ file that has none or one of zero length: the weighted mean over
/// the triangles at its position of the same smoothing group (group 0: flat), or over all triangles there
/// when the file has no smoothing groups.
void generate_missing_normals(ObjData& data, Weighting weighting);

/// Removes all normals, as if the file had no vn.
void remove_normals(ObjData& data);

}  // namespace texel::mesh
