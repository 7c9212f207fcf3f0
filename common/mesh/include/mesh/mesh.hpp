// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace texel::mesh {

/// A run of triangles drawn with one material, as `usemtl` gives them.
struct Group {
  std::string material;           ///< "" for none
  std::uint32_t first_index = 0;  ///< into Mesh::indices
  std::uint32_t index_count = 0;
};

/// A triangle mesh as the GPU takes it: one vertex for each distinct corner, indexed, counter-clockwise seen
/// from outside. An attribute is either empty or has one entry for each vertex. Object space; texcoord as
/// sampled, t up.
struct Mesh {
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;      ///< unit length
  std::vector<glm::vec2> texcoords;    ///< s to the right, t up
  std::vector<glm::vec4> tangents;     ///< xyz: direction of growing s; w: sign of the bitangent, +1 or -1
  std::vector<glm::vec3> bitangents;   ///< only of methods that keep their own, not a sign in tangents.w
  std::vector<glm::vec3> colors;       ///< linear RGB
  std::vector<std::uint32_t> indices;  ///< three a triangle
  std::vector<Group> groups;           ///< empty: one group with no material

  [[nodiscard]] std::size_t vertex_count() const { return positions.size(); }
  [[nodiscard]] std::size_t triangle_count() const { return indices.size() / 3; }
};

/// Calls `visit` with each of the mesh's attribute vectors, positions first, empty ones too.
template <class MeshType, class Visit>
void for_each_attribute(MeshType& mesh, Visit visit) {
  visit(mesh.positions);
  visit(mesh.normals);
  visit(mesh.texcoords);
  visit(mesh.tangents);
  visit(mesh.bitangents);
  visit(mesh.colors);
}

/// What a triangle's corners have of an attribute: of_triangle(mesh, mesh.positions, 7).
template <class Value>
std::array<Value, 3> of_triangle(const Mesh& mesh, const std::vector<Value>& values, std::size_t triangle) {
  const std::uint32_t* corners = &mesh.indices[3 * triangle];
  return {values[corners[0]], values[corners[1]], values[corners[2]]};
}

}  // namespace texel::mesh
