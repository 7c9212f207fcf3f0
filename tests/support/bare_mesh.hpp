// SPDX-License-Identifier: MIT
#pragma once
#include "mesh/mesh.hpp"
#include "steps.hpp"

namespace texel::test {

/// Positions and triangles alone, vertices at one place joined.
inline mesh::Mesh bare(const mesh::Mesh& mesh) {
  mesh::Mesh result;
  result.positions = mesh.positions;
  result.indices = mesh.indices;
  return cube_wrap::weld(result);
}

}  // namespace texel::test
