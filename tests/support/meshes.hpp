// SPDX-License-Identifier: MIT
// Meshes that only tests need.
#pragma once
#include <glm/geometric.hpp>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/tangents.hpp"
#include "mesh/vectors.hpp"

namespace texel::test {

inline constexpr mesh::TangentMethod tangent_methods[] = {
    mesh::TangentMethod::averaged, mesh::TangentMethod::gram_schmidt, mesh::TangentMethod::angle_weighted,
    mesh::TangentMethod::mikktspace};

inline double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
  return glm::degrees(mesh::angle_between(a, b));
}

/// A sphere of nearly equal triangles: an icosahedron split `subdivisions` times, 20 * 4^n triangles, 10 *
/// 4^n + 2 vertices; normals, and no texture coordinates.
inline mesh::Mesh icosphere(int subdivisions, float radius = 1.0F) {
  constexpr double g = std::numbers::phi;  // the golden ratio: (0, +-1, +-g) and its cyclic turns
  std::vector<glm::dvec3> points{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  for (glm::dvec3& point : points) point = glm::normalize(point);
  mesh::Mesh mesh;
  mesh.indices = {0, 11, 5,  0, 5,  1, 0, 1, 7, 0, 7,  10, 0, 10, 11, 1, 5, 9, 5, 11,
                  4, 11, 10, 2, 10, 7, 6, 7, 1, 8, 3,  9,  4, 3,  4,  2, 3, 2, 6, 3,
                  6, 8,  3,  8, 9,  4, 9, 5, 2, 4, 11, 6,  2, 10, 8,  6, 7, 9, 8, 1};
  for (int level = 0; level < subdivisions; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [place, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(points.size()));
      if (is_new) points.push_back(glm::normalize(points[a] + points[b]));
      return place->second;
    };
    std::vector<std::uint32_t> finer;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {a, ab, ca, b, bc, ab, c, ca, bc, ab, bc, ca});
    }
    mesh.indices = std::move(finer);
  }
  for (const glm::dvec3& point : points) {
    mesh.positions.emplace_back(double{radius} * point);
    mesh.normals.emplace_back(point);
  }
  return mesh;
}

}  // namespace texel::test
