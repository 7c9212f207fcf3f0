// SPDX-License-Identifier: MIT
#include "mesh/tangents.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "mesh/vectors.hpp"
#include "mesh/weld.hpp"
#include "mikktspace.hpp"

namespace texel::mesh {
namespace {

/// T and B of every triangle, zero for degenerate ones, and its turn: the sign of its texture area.
struct Frames {
  std::vector<TriangleFrame> of_triangle;
  std::vector<signed char> turn;  // +1, -1, or 0 for degenerate
};

Frames triangle_frames(const Mesh& mesh, unsigned threads) {
  Frames frames{std::vector<TriangleFrame>(mesh.triangle_count()),
                std::vector<signed char>(mesh.triangle_count())};
  in_runs(threads, mesh.triangle_count(), [&](std::size_t t) {
    const auto texcoords = of_triangle(mesh, mesh.texcoords, t);
    const double area = texture_area(texcoords);
    if (area == 0.0) return;
    const TriangleFrame frame = triangle_frame(of_triangle(mesh, mesh.positions, t), texcoords);
    // A triangle without area in space has T and B of zero length or along the same line.
    const glm::dvec3 across = glm::cross(glm::dvec3(frame.tangent), glm::dvec3(frame.bitangent));
    if (is_zero(unit_or_zero(across))) return;
    frames.of_triangle[t] = frame;
    frames.turn[t] = area > 0.0 ? 1 : -1;
  });
  return frames;
}

/// Gives triangles that turn the texture the other way than the first at a vertex a copy of that vertex.
void split_mirrored(Mesh& mesh, const std::vector<signed char>& turn) {
  std::vector<std::uint32_t> labels(mesh.indices.size());
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i] = turn[i / 3] == 0 ? no_index : (turn[i / 3] > 0 ? 1 : 0);
  split_by_label(mesh, labels);
}

TriangleFrame unit_frame(const TriangleFrame& frame) {
  return {unit_or_zero(frame.tangent), unit_or_zero(frame.bitangent)};
}

std::vector<TriangleFrame> sum_by_vertex(const Mesh& mesh, const Frames& frames) {
  std::vector<TriangleFrame> sums(mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const std::uint32_t* corners = &mesh.indices[3 * t];
    add_to_corners({corners[0], corners[1], corners[2]}, frames.of_triangle[t], sums);
  }
  return sums;
}

std::vector<TriangleFrame> sum_by_angle(const Mesh& mesh, const Frames& frames) {
  std::vector<TriangleFrame> sums(mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto angles = corner_angles(of_triangle(mesh, mesh.positions, t));
    const TriangleFrame unit = unit_frame(frames.of_triangle[t]);
    for (std::size_t k = 0; k < 3; ++k) {
      TriangleFrame& sum = sums[mesh.indices[3 * t + k]];
      sum.tangent += glm::vec3(angles[k] * glm::dvec3(unit.tangent));
      sum.bitangent += glm::vec3(angles[k] * glm::dvec3(unit.bitangent));
    }
  }
  return sums;
}

/// Unit averages of T and B as they are; the sign in w is there for those who rebuild B from N and T.
void store_averages(Mesh& mesh, const std::vector<TriangleFrame>& sums) {
  mesh.bitangents.resize(mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const glm::vec3& normal = mesh.normals[v];
    TriangleFrame unit = unit_frame(sums[v]);
    if (is_zero(unit.tangent)) unit.tangent = any_orthogonal(normal);
    if (is_zero(unit.bitangent)) unit.bitangent = unit_or_zero(glm::cross(normal, unit.tangent));
    if (is_zero(unit.bitangent)) unit.bitangent = any_orthogonal(unit.tangent);
    const bool mirrored = glm::determinant(glm::mat3(unit.tangent, unit.bitangent, normal)) < 0.0F;
    mesh.tangents[v] = {unit.tangent, mirrored ? -1.0F : 1.0F};
    mesh.bitangents[v] = unit.bitangent;
  }
}

void store_orthonormal(Mesh& mesh, const std::vector<TriangleFrame>& sums) {
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const glm::vec3& normal = mesh.normals[v];
    const glm::vec3 sum = unit_or_zero(sums[v].tangent);
    const glm::vec4 tangent = orthonormalize(normal, sum, sums[v].bitangent);
    const bool has_none = is_zero(glm::vec3(tangent)) || is_along(sum, normal);
    mesh.tangents[v] = has_none ? glm::vec4(any_orthogonal(normal), tangent.w) : tangent;
  }
}

}  // namespace

void compute_tangents(Mesh& mesh, TangentMethod method, unsigned threads) {
  if (mesh.texcoords.size() != mesh.vertex_count())
    throw Error::failed("tangents need texture coordinates, and the mesh has none", {},
                        "add vt lines to the file, or choose a projection");
  if (mesh.normals.size() != mesh.vertex_count())
    throw Error::failed("tangents need normals, and the mesh has none", {},
                        "generate flat or smooth normals");
  // With less for each to do, starting a thread takes longer.
  constexpr std::size_t least = 10'000;
  if (threads == 0)
    threads = static_cast<unsigned>(std::clamp<std::size_t>(mesh.triangle_count() / least, 1, processors()));
  mesh.bitangents.clear();
  mesh.tangents.assign(mesh.vertex_count(), glm::vec4(0.0F));
  if (method == TangentMethod::mikktspace) return mikktspace(mesh, threads);
  const Frames frames = triangle_frames(mesh, threads);
  if (method == TangentMethod::averaged) return store_averages(mesh, sum_by_vertex(mesh, frames));
  split_mirrored(mesh, frames.turn);
  store_orthonormal(mesh, method == TangentMethod::angle_weighted ? sum_by_angle(mesh, frames)
                                                                  : sum_by_vertex(mesh, frames));
}

}  // namespace texel::mesh
