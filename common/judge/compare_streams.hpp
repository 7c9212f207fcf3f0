// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "image/image.hpp"
#include "judge/judge.hpp"
#include "mesh/mesh.hpp"

namespace texel::judge {

/// Judges a vertex stream. Vertices are matched by position and texture coordinate, so that their order does
/// not matter; what is compared are their normals and tangents, direction and length, and the sum of the
/// angles of the triangles around them, each with its triangle's direction, which is the same however a flat
/// polygon was cut. `limit` is in degrees. A number of vertices other than the reference's fails.
Verdict compare_streams(double limit, mesh::Mesh reference, mesh::Mesh own);

/// Two streams, and whether the vertices of the own one are the reference's by their indices.
struct VertexPairs {
  mesh::Mesh reference, own;
  std::vector<glm::dvec3> reference_sums,
      own_sums;  ///< of each vertex' triangles: angle times unit normal, degrees
  bool are_pairs = false;
};
VertexPairs paired(mesh::Mesh reference, mesh::Mesh own);

/// The mask's pixels of the object, or of the background, without those beside the other: where the object's
/// edge passes between them is the rasteriser's choice.
image::Image8 part_of(const image::Image8& mask, bool is_object);

}  // namespace texel::judge
