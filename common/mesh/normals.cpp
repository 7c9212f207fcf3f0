// SPDX-License-Identifier: MIT
#include "mesh/normals.hpp"

#include <algorithm>
#include <array>

#include "mesh/distinct.hpp"
#include "mesh/vectors.hpp"
#include "mesh/weld.hpp"
#include "newell.hpp"

namespace texel::mesh {
namespace {

std::uint64_t hash_of(const glm::vec3& v) {
  return mix(mix(std::uint64_t{value_bits(v.x)} << 32 | value_bits(v.y)) ^ value_bits(v.z));
}

/// For each position the number of its distinct value.
std::vector<std::uint32_t> number_places(const std::vector<glm::vec3>& positions) {
  Distinct<glm::vec3> distinct(positions.size());
  std::vector<std::uint32_t> numbers;
  numbers.reserve(positions.size());
  for (const glm::vec3& position : positions) numbers.push_back(distinct.number(hash_of(position), position));
  return numbers;
}

/// Adds up the normals of the triangles at each key. `position(i)` and `key(i)` are those of the i-th corner.
template <class Position, class Key>
std::vector<glm::vec3> sum_normals(std::size_t corner_count, std::size_t key_count, Weighting weighting,
                                   FaceNormal face_normal, Position position, Key key) {
  std::vector<glm::dvec3> sums(key_count, glm::dvec3(0.0));
  for (std::size_t i = 0; i + 2 < corner_count; i += 3) {
    const std::array<glm::vec3, 3> p{position(i), position(i + 1), position(i + 2)};
    const glm::dvec3 normal(face_normal(p[0], p[1], p[2]));
    std::array<double, 3> weights{};
    if (weighting == Weighting::angle)
      weights = corner_angles(p);
    else
      weights.fill(glm::length(newell_normal(p)));  // twice the area: the factor cancels
    for (std::size_t k = 0; k < 3; ++k) sums[key(i + k)] += weights[k] * normal;
  }
  std::vector<glm::vec3> normals(key_count);
  for (std::size_t k = 0; k < key_count; ++k) {
    normals[k] = unit_or_zero(sums[k]);
    if (is_zero(normals[k])) normals[k] = fallback_normal;
  }
  return normals;
}

/// For each corner the number of its (position, smoothing group); in group 0 each triangle is on its own.
std::vector<std::uint32_t> smoothing_keys(const ObjData& data) {
  const std::vector<std::uint32_t> place = number_places(data.positions);
  Distinct<std::pair<std::uint32_t, std::uint64_t>> distinct(data.positions.size());
  std::vector<std::uint32_t> keys(data.corners.size());
  std::size_t run = 0;
  for (std::size_t i = 0; i < data.corners.size(); ++i) {
    while (run + 1 < data.smoothing.size() && data.smoothing[run + 1].first_triangle <= i / 3) ++run;
    const std::uint32_t position = place[data.corners[i].position],
                        group = data.smoothing.empty() ? 1 : data.smoothing[run].group;
    // Above all groups there is one for each triangle of group 0.
    const std::uint64_t smooth_with = group != 0 ? group : std::uint64_t{i / 3 + 1} << 32;
    keys[i] = distinct.number(mix(mix(position) ^ smooth_with), {position, smooth_with});
  }
  return keys;
}

}  // namespace

void flat_normals(Mesh& mesh, FaceNormal face_normal) {
  if (face_normal == nullptr) face_normal = newell_unit;
  mesh.tangents.clear();
  mesh.bitangents.clear();
  Distinct<glm::vec3> normals(mesh.triangle_count());
  std::vector<std::uint32_t> labels;
  labels.reserve(mesh.indices.size());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = of_triangle(mesh, mesh.positions, t);
    glm::vec3 normal = face_normal(a, b, c);
    if (is_zero(normal)) normal = fallback_normal;
    labels.insert(labels.end(), 3, normals.number(hash_of(normal), normal));
  }
  mesh.normals.clear();
  for (const std::uint32_t n : split_by_label(mesh, labels))
    mesh.normals.push_back(n == no_index ? fallback_normal : normals.things()[n]);
}

void smooth_normals(Mesh& mesh, Weighting weighting, FaceNormal face_normal) {
  if (face_normal == nullptr) face_normal = newell_unit;
  mesh.tangents.clear();
  mesh.bitangents.clear();
  const std::vector<std::uint32_t> place = number_places(mesh.positions);
  const std::vector<glm::vec3> normals = sum_normals(
      mesh.indices.size(), mesh.vertex_count(), weighting, face_normal,
      [&](std::size_t i) { return mesh.positions[mesh.indices[i]]; },
      [&](std::size_t i) { return place[mesh.indices[i]]; });
  mesh.normals.resize(mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) mesh.normals[v] = normals[place[v]];
}

void generate_missing_normals(ObjData& data, Weighting weighting) {
  const auto is_missing = [&](const Corner& corner) {
    return corner.normal == no_index || is_zero(unit_or_zero(data.normals[corner.normal]));
  };
  if (std::none_of(data.corners.begin(), data.corners.end(), is_missing)) return;
  const std::vector<std::uint32_t> keys = smoothing_keys(data);
  const std::size_t key_count = std::size_t{*std::max_element(keys.begin(), keys.end())} + 1;
  const std::vector<glm::vec3> generated = sum_normals(
      data.corners.size(), key_count, weighting, newell_unit,
      [&](std::size_t i) { return data.positions[data.corners[i].position]; },
      [&](std::size_t i) { return keys[i]; });
  const auto first = static_cast<std::uint32_t>(data.normals.size());
  for (std::size_t i = 0; i < data.corners.size(); ++i)
    if (is_missing(data.corners[i])) data.corners[i].normal = first + keys[i];
  data.normals.insert(data.normals.end(), generated.begin(), generated.end());
}

void remove_normals(ObjData& data) {
  data.normals.clear();
  for (Corner& corner : data.corners) corner.normal = no_index;
}

}  // namespace texel::mesh
