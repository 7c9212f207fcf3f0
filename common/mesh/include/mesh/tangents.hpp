// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "mesh/mesh.hpp"

namespace texel::mesh {

/// How the tangent frames of a triangle mesh are made from its texture coordinates.
enum class TangentMethod {
  /// The slides' way: T and B of each triangle by the 2x2 inverse, averaged per vertex, not orthogonal. Fills
  /// Mesh::bitangents too. Vertices are left as they are, so mirrored texture coordinates cancel.
  averaged,
  /// The averaged T made orthogonal to the normal, the side of B kept in w (Lengyel, "Foundations of Game
  /// Engine Development 2", section 7.5). The first method that splits mirrored vertices.
  gram_schmidt,
  /// As gram_schmidt, but each triangle's unit T and B are weighted by the angle at its corner. How a face
  /// is cut into triangles then does not matter (Thuermer and Wuethrich 1998, there for normals).
  angle_weighted,
  /// The rules of M. S. Mikkelsen, "Simulation of Wrinkled Surfaces Revisited" (2008), and of the MikkTSpace
  /// reference code, to the last bit: the triangles around a corner that are joined by edges and turn the
  /// texture the same way share a tangent, the sum of their unit T in the normal's plane, by the corner's
  /// angle there. Each tangent has a vertex of its own. What no such group reaches is (1, 0, 0) with sign -1.
  /// Unlike there, that is turned into the normal's plane where there is no texture area, and a tangent along
  /// the normal, which makes no frame, is replaced by one in the plane.
  mikktspace,
};

/// T and B: the moves on the triangle when s or t grows by 1, as long as the texture's width and height.
struct TriangleFrame {
  glm::vec3 tangent{0.0F};
  glm::vec3 bitangent{0.0F};
};

// What lab 5 teaches of it: files in labs/05_normal_map define these functions.

/// T and B of a triangle from E1 = P2 - P1, E2 = P3 - P2 and the same differences of its texture coordinates,
/// by the inverse of the 2x2 matrix (Slides, "Normal Mapping"). The texture area must not be zero.
TriangleFrame triangle_frame(const std::array<glm::vec3, 3>& positions,
                             const std::array<glm::vec2, 3>& texcoords);

/// T without its part along the unit normal, at unit length, and in w the side on which B lies: the bitangent
/// is w * cross(normal, xyz). Zero in xyz when T has no part in the normal's plane.
glm::vec4 orthonormalize(const glm::vec3& normal, const glm::vec3& tangent, const glm::vec3& bitangent);

/// Adds a triangle's T and B to each of its three vertices' sums.
void add_to_corners(const std::array<std::uint32_t, 3>& corners, const TriangleFrame& frame,
                    std::vector<TriangleFrame>& sums);

/// Twice the signed area in texture space: positive when the texture is not mirrored, and exactly 0 when the
/// three texture coordinates lie on a line up to rounding (area below 1e-7 of the product of two edges).
inline double texture_area(const std::array<glm::vec2, 3>& texcoords) {
  const glm::dvec2 a = glm::dvec2(texcoords[1]) - glm::dvec2(texcoords[0]);
  const glm::dvec2 b = glm::dvec2(texcoords[2]) - glm::dvec2(texcoords[0]);
  const double area = a.x * b.y - a.y * b.x;
  return std::abs(area) > 1e-7 * glm::length(a) * glm::length(b) ? area : 0.0;
}

/// Fills tangents (and bitangents for `averaged`, else empties them) from positions, normals and texcoords.
/// Where mirrored and other triangles share a vertex, all methods except `averaged` append a vertex for the
/// later kind. Else the order of vertices and triangles stays. Expected linear time. The result does not
/// depend on the number of `threads`; 0 takes as many as the processor has cores, and one for a small mesh.
/// Throws Error (exit 3) when the mesh has no normals or no texture coordinates.
void compute_tangents(Mesh& mesh, TangentMethod method, unsigned threads = 0);

}  // namespace texel::mesh
