// SPDX-License-Identifier: MIT
#pragma once
#include "mesh/tangents.hpp"

namespace texel::mesh {

/// TangentMethod::mikktspace for compute_tangents, which has looked at the mesh and chosen the number of
/// threads.
TangentReport mikktspace(Mesh& mesh, unsigned threads);

}  // namespace texel::mesh
