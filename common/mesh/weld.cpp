// SPDX-License-Identifier: MIT
#include "mesh/weld.hpp"

#include <fmt/format.h>

#include <string_view>
#include <unordered_map>
#include <utility>

#include "core/error.hpp"
#include "mesh/corner_numbers.hpp"
#include "mesh/distinct.hpp"
#include "mesh/normals.hpp"
#include "mesh/vectors.hpp"

namespace texel::mesh {
namespace {

/// The triangles from one number to before another.
using Run = std::pair<std::size_t, std::size_t>;

/// The runs of triangles of each material, materials in order of first use.
std::vector<std::pair<std::string, std::vector<Run>>> runs_by_material(const ObjData& data) {
  std::vector<NamedRun> runs = data.material_runs;
  runs.insert(runs.begin(), NamedRun{});  // before the first one there is no material
  std::vector<std::pair<std::string, std::vector<Run>>> materials;
  std::unordered_map<std::string_view, std::size_t> place;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const std::size_t first = runs[i].first_triangle;
    const std::size_t end = i + 1 < runs.size() ? runs[i + 1].first_triangle : data.triangle_count();
    if (first == end) continue;
    const auto [known, is_new] = place.try_emplace(runs[i].name, materials.size());
    if (is_new) materials.push_back({runs[i].name, {}});
    materials[known->second].second.emplace_back(first, end);
  }
  return materials;
}

}  // namespace

Mesh weld(ObjData data) {
  if (!data.normals.empty()) generate_missing_normals(data, Weighting::angle);
  Mesh mesh;
  CornerNumbers numbers(data.positions.size());
  mesh.indices.reserve(data.corners.size());
  for (const auto& [material, runs] : runs_by_material(data)) {
    const auto first = static_cast<std::uint32_t>(mesh.indices.size());
    for (const auto& [begin, end] : runs)
      for (std::size_t i = 3 * begin; i < 3 * end; ++i) {
        mesh.indices.push_back(numbers.number(data.corners[i]));
        if (mesh.indices.back() >= numbers.distinct().size())
          throw Error::failed(fmt::format("CornerNumbers::number gave {}, and distinct_ has {} corners",
                                          mesh.indices.back(), numbers.distinct().size()),
                              {"labs/03_obj_texcoords/corner_numbers.cpp"});
      }
    mesh.groups.push_back({material, first, static_cast<std::uint32_t>(mesh.indices.size()) - first});
  }
  if (mesh.groups.size() == 1 && mesh.groups[0].material.empty()) mesh.groups.clear();
  data.corners = {};  // done with: given back before the vertices take room

  const std::vector<Corner>& distinct = numbers.distinct();
  const auto fill = [&distinct](auto& values, bool has_any, auto value_of) {
    if (!has_any) return;
    values.reserve(distinct.size());
    for (const Corner& corner : distinct) values.push_back(value_of(corner));
  };
  fill(mesh.positions, true, [&](const Corner& corner) { return data.positions[corner.position]; });
  fill(mesh.texcoords, !data.texcoords.empty(), [&](const Corner& corner) {
    return corner.texcoord == no_index ? glm::vec2(0.0F) : data.texcoords[corner.texcoord];
  });
  fill(mesh.normals, !data.normals.empty(),
       [&](const Corner& corner) { return unit_or_zero(data.normals[corner.normal]); });
  return mesh;
}

Mesh take_vertices(const Mesh& mesh, const std::vector<std::uint32_t>& vertices) {
  Mesh taken = mesh;
  taken.indices.clear();
  for_each_attribute(taken, [&vertices](auto& values) {
    if (values.empty()) return;
    const auto all = std::exchange(values, {});
    values.reserve(vertices.size());
    for (const std::uint32_t vertex : vertices) values.push_back(all[vertex]);
  });
  return taken;
}

Mesh split(const Mesh& mesh) {
  Mesh result = take_vertices(mesh, mesh.indices);
  result.indices.resize(mesh.indices.size());
  for (std::uint32_t i = 0; i < result.indices.size(); ++i) result.indices[i] = i;
  return result;
}

std::uint32_t duplicate_vertex(Mesh& mesh, std::uint32_t vertex) {
  for_each_attribute(mesh, [vertex](auto& values) {
    if (values.empty()) return;
    const auto copy = values[vertex];  // by value: push_back may move what a reference points at
    values.push_back(copy);
  });
  return static_cast<std::uint32_t>(mesh.vertex_count() - 1);
}

std::vector<std::uint32_t> split_by_label(Mesh& mesh, std::span<const std::uint32_t> labels) {
  std::vector<std::uint32_t> label_of_vertex(mesh.vertex_count(), no_index);
  Distinct<std::pair<std::uint32_t, std::uint32_t>> further;  // a vertex and a label of its corners
  std::vector<std::uint32_t> copies;                          // the vertex for each of them
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    std::uint32_t& vertex = mesh.indices[i];
    const std::uint32_t label = labels[i];
    if (label == no_index) continue;
    if (label_of_vertex[vertex] == no_index) label_of_vertex[vertex] = label;
    if (label_of_vertex[vertex] == label) continue;
    const std::uint32_t n = further.number(mix(std::uint64_t{vertex} << 32 | label), {vertex, label});
    if (n == copies.size()) {
      copies.push_back(duplicate_vertex(mesh, vertex));
      label_of_vertex.push_back(label);
    }
    vertex = copies[n];
  }
  return label_of_vertex;
}

}  // namespace texel::mesh
