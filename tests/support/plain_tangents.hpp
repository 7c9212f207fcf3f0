// SPDX-License-Identifier: MIT
#pragma once
#include "mesh/tangents.hpp"

namespace texel::mesh {

/// The rules of TangentMethod::mikktspace step by step, with the standard library's containers, the square of
/// the triangles around a vertex, and one thread: what compute_tangents must equal to the last bit, and what
/// its speed is measured against. The mesh has normals and texture coordinates, all finite.
void plain_mikktspace(Mesh& mesh);

}  // namespace texel::mesh
