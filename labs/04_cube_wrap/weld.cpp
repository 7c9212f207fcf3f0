// SPDX-License-Identifier: MIT
// Step 4.2. Which vertices are the same, and need to be stored only once.
#include "mesh/weld.hpp"
#include "mesh/distinct.hpp"
#include "steps.hpp"

namespace texel::cube_wrap {
namespace {

/// Calls `visit` with each of the mesh's attribute vectors by which two vertices can differ, empty ones too.
template <class Visit>
void for_each_difference(const mesh::Mesh& mesh, Visit visit) {
  //@step 4.2 begin
  for_each_attribute(mesh, visit);
  //@starter
  // visit(mesh.positions);  // one vertex for each place cannot hold two texture coordinates or normals
  //@end
}

}  // namespace

mesh::Mesh weld(const mesh::Mesh& mesh) {
  std::vector<std::uint32_t> vertices;  // the first of each kind
  std::vector<std::uint32_t> indices;
  indices.reserve(mesh.indices.size());
  mesh::DistinctTable table(mesh.vertex_count());
  for (const std::uint32_t vertex : mesh.indices) {
    std::uint64_t hash = 0;
    for_each_difference(mesh, [&](const auto& values) {
      if (values.empty()) return;
      for (int k = 0; k < values[vertex].length(); ++k)
        hash = mesh::mix(hash ^ mesh::value_bits(values[vertex][k]));
    });
    const std::uint32_t n = table.number(hash, [&](std::uint32_t known) {
      bool same = true;
      for_each_difference(mesh, [&](const auto& values) {
        same = same && (values.empty() || values[vertices[known]] == values[vertex]);
      });
      return same;
    });
    if (n == vertices.size()) vertices.push_back(vertex);
    indices.push_back(n);
  }
  mesh::Mesh welded = take_vertices(mesh, vertices);
  welded.indices = std::move(indices);
  return welded;
}

}  // namespace texel::cube_wrap
