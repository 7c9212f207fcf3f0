// SPDX-License-Identifier: MIT
#include "mesh/primitives.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mesh/distinct.hpp"

namespace texel::mesh {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

void add_vertex(Mesh& mesh, const glm::dvec3& position, const glm::dvec3& normal,
                const glm::dvec2& texcoord) {
  mesh.positions.emplace_back(position);
  mesh.normals.emplace_back(normal);
  mesh.texcoords.emplace_back(texcoord);
}

/// Joins (columns + 1) x (rows + 1) vertices that lie row by row from `first` on, s along a row, t from row
/// to row.
void add_grid_squares(Mesh& mesh, std::uint32_t first, int columns, int rows) {
  const auto width = static_cast<std::uint32_t>(columns) + 1;
  for (std::uint32_t j = 0; j < static_cast<std::uint32_t>(rows); ++j)
    for (std::uint32_t i = 0; i + 1 < width; ++i) {
      const std::uint32_t a = first + j * width + i;
      const std::uint32_t b = a + 1, c = b + width, d = a + width;
      mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    }
}

/// How far the vertex (i, j) slides, in cells: it depends on nothing but the arguments.
glm::dvec2 slide(const Jitter& jitter, int i, int j) {
  const std::uint64_t place =
      std::uint64_t{static_cast<std::uint32_t>(i)} << 32 | static_cast<std::uint32_t>(j);
  const auto hashed = [&](std::uint32_t axis) {  // in [-1/2, 1/2)
    const std::uint64_t h = mix(mix(std::uint64_t{jitter.seed} << 32 | axis) ^ place);
    return static_cast<double>(h >> 11) * 0x1p-53 - 0.5;
  };
  return double{jitter.amount} * glm::dvec2(hashed(0), hashed(1));
}

/// A square about `center` in cells x cells squares, its sides 2 right and 2 up long. Its border stays in
/// place.
void add_plane(Mesh& mesh, const glm::dvec3& center, const glm::dvec3& right, const glm::dvec3& up, int cells,
               const Jitter& jitter) {
  const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
  const glm::dvec3 normal = glm::normalize(glm::cross(right, up));
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) {
      const bool inside = i > 0 && i < cells && j > 0 && j < cells;
      const glm::dvec2 st =
          (glm::dvec2(i, j) + (inside ? slide(jitter, i, j) : glm::dvec2(0.0))) / double(cells);
      const glm::dvec2 xy = 2.0 * st - 1.0;
      add_vertex(mesh, center + xy.x * right + xy.y * up, normal, st);
    }
  add_grid_squares(mesh, first, cells, cells);
}

}  // namespace

Mesh quad(float half_size, int cells, Jitter jitter) {
  Mesh mesh;
  add_plane(mesh, glm::dvec3(0.0), {half_size, 0.0, 0.0}, {0.0, half_size, 0.0}, cells, jitter);
  return mesh;
}

Mesh cube_split(float half_size, int cells, Jitter jitter) {
  // Right and up of each face, as seen from outside; the face looks along right x up.
  constexpr std::array<std::array<glm::dvec3, 2>, 6> faces{{{{{1, 0, 0}, {0, 1, 0}}},
                                                            {{{-1, 0, 0}, {0, 1, 0}}},
                                                            {{{0, 0, -1}, {0, 1, 0}}},
                                                            {{{0, 0, 1}, {0, 1, 0}}},
                                                            {{{1, 0, 0}, {0, 0, -1}}},
                                                            {{{1, 0, 0}, {0, 0, 1}}}}};
  Mesh mesh;
  const double h = half_size;
  for (const auto& [right, up] : faces)
    add_plane(mesh, h * glm::cross(right, up), h * right, h * up, cells, jitter);
  return mesh;
}

Mesh sphere(int rings, int segments, float radius, Jitter jitter) {
  Mesh mesh;
  rings = std::max(rings, 2);
  segments = std::max(segments, 3);
  const auto add = [&](double column, double row) {
    const double s = column / segments, t = row / rings;
    const double latitude = std::numbers::pi * (t - 0.5);
    // The poles exactly: the cosine of a rounded pi / 2 is not zero.
    const double around = t == 0.0 || t == 1.0 ? 0.0 : std::cos(latitude);
    const glm::dvec3 normal(around * std::sin(two_pi * s), std::sin(latitude), around * std::cos(two_pi * s));
    add_vertex(mesh, double{radius} * normal, normal, {s, t});
  };
  for (int j = 1; j < rings; ++j)
    for (int i = 0; i <= segments; ++i) {
      const glm::dvec2 place = glm::dvec2(i, j) + slide(jitter, i % segments, j);
      add(place.s, place.t);
      if (i < segments) continue;  // the seam's second copy lies exactly on the first
      const std::size_t begin = mesh.vertex_count() - 1 - static_cast<std::size_t>(segments);
      mesh.positions.back() = mesh.positions[begin];
      mesh.normals.back() = mesh.normals[begin];
    }
  const auto count = static_cast<std::uint32_t>(segments);
  const auto south = static_cast<std::uint32_t>(mesh.vertex_count());
  for (const int ring : {0, rings})
    for (int i = 0; i < segments; ++i) add(i + 0.5, ring);

  const std::uint32_t last_ring = static_cast<std::uint32_t>(rings - 2) * (count + 1);
  for (std::uint32_t i = 0; i < count; ++i) mesh.indices.insert(mesh.indices.end(), {south + i, i + 1, i});
  add_grid_squares(mesh, 0, segments, rings - 2);
  for (std::uint32_t i = 0; i < count; ++i)
    mesh.indices.insert(mesh.indices.end(), {last_ring + i, last_ring + i + 1, south + count + i});
  return mesh;
}

Mesh torus(float major, float minor, int segments, int sides, Jitter jitter) {
  Mesh mesh;
  segments = std::max(segments, 3);
  sides = std::max(sides, 3);
  for (int j = 0; j <= sides; ++j)
    for (int i = 0; i <= segments; ++i) {
      // Both copies of a seam's vertex are made from the same place, a whole turn apart in s or t only.
      const int i0 = i % segments, j0 = j % sides;
      const glm::dvec2 place = glm::dvec2(i0, j0) + slide(jitter, i0, j0);
      const double s = place.s / segments, t = place.t / sides;
      const double a = two_pi * s, b = two_pi * t;
      const glm::dvec3 outward(std::sin(a), 0.0, std::cos(a));
      const glm::dvec3 normal = std::cos(b) * outward + glm::dvec3(0.0, std::sin(b), 0.0);
      add_vertex(mesh, double{major} * outward + double{minor} * normal, normal,
                 {s + (i == segments ? 1.0 : 0.0), t + (j == sides ? 1.0 : 0.0)});
    }
  add_grid_squares(mesh, 0, segments, sides);
  return mesh;
}

void revolution_tangents(Mesh& mesh) {
  mesh.bitangents.clear();
  mesh.tangents.clear();
  mesh.tangents.reserve(mesh.vertex_count());
  for (const glm::vec2& texcoord : mesh.texcoords) {
    const double a = two_pi * double{texcoord.s};
    mesh.tangents.emplace_back(glm::dvec4(std::cos(a), 0.0, -std::sin(a), 1.0));
  }
}

}  // namespace texel::mesh
