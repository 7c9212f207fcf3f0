// SPDX-License-Identifier: MIT
#pragma once
#include "judge/judge.hpp"
#include "mesh/mesh.hpp"

namespace texel::judge {

/// Judges a vertex stream. Vertices are matched by position and texture coordinate, so that their order does
/// not matter; what is compared are their normals and tangents, direction and length, and the sum of the
/// angles of the triangles around them, each with its triangle's direction, which is the same however a flat
/// polygon was cut. `limit` is in degrees. A number of vertices other than the reference's fails.
Verdict compare_streams(double limit, mesh::Mesh reference, mesh::Mesh own);

}  // namespace texel::judge
