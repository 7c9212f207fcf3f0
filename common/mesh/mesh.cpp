// SPDX-License-Identifier: MIT
#include "mesh/mesh.hpp"

namespace texel::mesh {

std::uint32_t duplicate_vertex(Mesh& mesh, std::uint32_t vertex) {
  for_each_attribute(mesh, [vertex](auto& values) {
    if (values.empty()) return;
    const auto copy = values[vertex];  // by value: push_back may move what a reference points at
    values.push_back(copy);
  });
  return static_cast<std::uint32_t>(mesh.vertex_count() - 1);
}

}  // namespace texel::mesh
