// SPDX-License-Identifier: MIT
#include "mesh/weld.hpp"

#include <array>
#include <cmath>
#include <string_view>
#include <unordered_map>

#include "mesh/corner_numbers.hpp"
#include "mesh/distinct.hpp"
#include "mesh/normals.hpp"
#include "mesh/vectors.hpp"

namespace texel::mesh {
namespace {

/// The part of a linear colour that the sRGB-encoded value means (IEC 61966-2-1). Finite for 1e30 too.
float linear_from_srgb(float encoded) {
  const double c = encoded, linear = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  return static_cast<float>(std::min<double>(linear, std::numeric_limits<float>::max()));
}

struct Run {
  std::uint32_t first_triangle, end_triangle;
};

/// The runs of triangles of each material, materials in order of first use.
struct MaterialRuns {
  std::string_view material;
  std::vector<Run> runs;
};

std::vector<MaterialRuns> runs_by_material(const ObjData& data) {
  std::vector<MaterialRuns> materials;
  std::unordered_map<std::string_view, std::size_t> place;
  const auto add = [&](std::string_view name, std::size_t first, std::size_t end) {
    if (first == end) return;
    const auto [known, is_new] = place.try_emplace(name, materials.size());
    if (is_new) materials.push_back({name, {}});
    materials[known->second].runs.push_back(
        {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end)});
  };
  const auto& runs = data.material_runs;
  add("", 0, runs.empty() ? data.triangle_count() : runs.front().first_triangle);
  for (std::size_t i = 0; i < runs.size(); ++i)
    add(runs[i].name, runs[i].first_triangle,
        i + 1 < runs.size() ? runs[i + 1].first_triangle : data.triangle_count());
  return materials;
}

template <class Value>
std::vector<Value> gather(const std::vector<Value>& values, const std::vector<std::uint32_t>& at) {
  std::vector<Value> gathered;
  if (values.empty()) return gathered;
  gathered.reserve(at.size());
  for (const std::uint32_t i : at) gathered.push_back(values[i]);
  return gathered;
}

}  // namespace

Mesh weld(ObjData data) {
  if (!data.normals.empty()) generate_missing_normals(data, Weighting::angle);
  Mesh mesh;
  const std::vector<MaterialRuns> materials = runs_by_material(data);
  CornerNumbers numbers(data.positions.size());
  mesh.indices.reserve(data.corners.size());
  for (const MaterialRuns& material : materials) {
    const auto first = static_cast<std::uint32_t>(mesh.indices.size());
    for (const Run& run : material.runs) {
      for (std::size_t i = 3 * std::size_t{run.first_triangle}; i < 3 * std::size_t{run.end_triangle}; ++i)
        mesh.indices.push_back(numbers.number(data.corners[i]));
    }
    mesh.groups.push_back(
        {std::string(material.material), first, static_cast<std::uint32_t>(mesh.indices.size()) - first});
  }
  if (mesh.groups.size() == 1 && mesh.groups[0].material.empty()) mesh.groups.clear();
  data.corners = {};  // done with: given back before the vertices take room

  const std::vector<Corner>& distinct = numbers.distinct();
  mesh.positions.reserve(distinct.size());
  for (const Corner& corner : distinct) mesh.positions.push_back(data.positions[corner.position]);
  if (!data.texcoords.empty()) {
    mesh.texcoords.reserve(distinct.size());
    for (const Corner& corner : distinct)
      mesh.texcoords.push_back(corner.texcoord == no_index ? glm::vec2(0.0f)
                                                           : data.texcoords[corner.texcoord]);
  }
  if (!data.normals.empty()) {
    mesh.normals.reserve(distinct.size());
    for (const Corner& corner : distinct) mesh.normals.push_back(unit_or_zero(data.normals[corner.normal]));
  }
  if (!data.colors.empty()) {
    mesh.colors.reserve(distinct.size());
    for (const Corner& corner : distinct) {
      const glm::vec3& c = data.colors[corner.position];
      mesh.colors.emplace_back(linear_from_srgb(c.r), linear_from_srgb(c.g), linear_from_srgb(c.b));
    }
  }
  return mesh;
}

Mesh take_vertices(const Mesh& mesh, const std::vector<std::uint32_t>& vertices) {
  Mesh taken;
  taken.positions = gather(mesh.positions, vertices);
  taken.normals = gather(mesh.normals, vertices);
  taken.texcoords = gather(mesh.texcoords, vertices);
  taken.tangents = gather(mesh.tangents, vertices);
  taken.bitangents = gather(mesh.bitangents, vertices);
  taken.colors = gather(mesh.colors, vertices);
  taken.groups = mesh.groups;
  return taken;
}

Mesh split(const Mesh& mesh) {
  Mesh result = take_vertices(mesh, mesh.indices);
  result.indices.resize(mesh.indices.size());
  for (std::uint32_t i = 0; i < result.indices.size(); ++i) result.indices[i] = i;
  return result;
}

std::vector<std::uint32_t> split_by_label(Mesh& mesh, std::span<const std::uint32_t> labels) {
  std::vector<std::uint32_t> label_of_vertex(mesh.vertex_count(), no_index);
  std::vector<std::array<std::uint32_t, 3>> copies;  // vertex, label, copy
  DistinctTable table;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    std::uint32_t& vertex = mesh.indices[i];
    const std::uint32_t label = labels[i];
    if (label == no_index) continue;
    if (label_of_vertex[vertex] == no_index) label_of_vertex[vertex] = label;
    if (label_of_vertex[vertex] == label) continue;
    const std::uint32_t n = table.number(mix(std::uint64_t{vertex} << 32 | label), [&](std::uint32_t known) {
      return copies[known][0] == vertex && copies[known][1] == label;
    });
    if (n == copies.size()) {
      copies.push_back({vertex, label, duplicate_vertex(mesh, vertex)});
      label_of_vertex.push_back(label);
    }
    vertex = copies[n][2];
  }
  return label_of_vertex;
}

}  // namespace texel::mesh
