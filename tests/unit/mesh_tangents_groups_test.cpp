// SPDX-License-Identifier: MIT
// Which triangles share a tangent, and by how much each of them counts: fans of a few triangles around one
// vertex, worked out by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "mesh/tangents.hpp"
#include "mesh/vectors.hpp"

namespace texel::mesh {
namespace {

constexpr double degree = 0.017453292519943295;

/// A fan around vertex 0, which lies at the origin with texture coordinate (0, 0).
Mesh fan(const std::vector<glm::vec3>& around, const std::vector<glm::vec2>& texcoords,
         const glm::vec3& normal = {0, 0, 1}) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}};
  mesh.texcoords = {{0, 0}};
  mesh.positions.insert(mesh.positions.end(), around.begin(), around.end());
  mesh.texcoords.insert(mesh.texcoords.end(), texcoords.begin(), texcoords.end());
  mesh.normals.assign(mesh.vertex_count(), normal);
  for (std::uint32_t i = 1; i + 1 < mesh.vertex_count(); ++i)
    mesh.indices.insert(mesh.indices.end(), {0, i, i + 1});
  return mesh;
}

void expect_tangent(const Mesh& mesh, std::size_t vertex, const glm::dvec3& direction) {
  const glm::dvec3 expected = glm::normalize(direction);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(mesh.tangents[vertex][k], expected[k], 1e-6) << vertex;
}

/// A quarter turn with the texture straight, then an eighth where T, solved for by hand, is (1, 1/2, 0).
Mesh bent_fan() {
  return fan({{1, 0, 0}, {0, 1, 0}, {-1, 1, 0}}, {{1, 0}, {0, 1}, {-1, 1.5F}});
}

TEST(TangentWeights, are_lengths_angles_or_angles_by_method) {
  const glm::dvec3 first(1, 0, 0), second(1, 0.5, 0), unit_second = glm::normalize(second);
  Mesh mesh = bent_fan();
  compute_tangents(mesh, TangentMethod::gram_schmidt);
  expect_tangent(mesh, 0, first + second);
  for (const TangentMethod method : {TangentMethod::angle_weighted, TangentMethod::mikktspace}) {
    mesh = bent_fan();
    compute_tangents(mesh, method);
    expect_tangent(mesh, 0, 90.0 * first + 45.0 * unit_second);
  }
}

TEST(Mikktspace, measures_angles_and_tangents_in_the_plane_of_the_vertex_normal) {
  const glm::dvec3 normal = glm::normalize(glm::dvec3(0.6, 0.3, 1));
  Mesh mesh = bent_fan();
  mesh.normals.assign(mesh.vertex_count(), glm::vec3(normal));
  compute_tangents(mesh, TangentMethod::mikktspace);
  const auto in_plane = [&](const glm::dvec3& v) { return glm::normalize(v - glm::dot(v, normal) * normal); };
  const auto angle = [&](const glm::dvec3& a, const glm::dvec3& b) {
    return std::acos(glm::dot(in_plane(a), in_plane(b)));
  };
  expect_tangent(mesh, 0,
                 angle({1, 0, 0}, {0, 1, 0}) * in_plane({1, 0, 0}) +
                     angle({0, 1, 0}, {-1, 1, 0}) * in_plane({1, 0.5, 0}));
}

TEST(Mikktspace, goes_through_a_triangle_without_texture_area) {
  // The middle triangle's texture is a line; its neighbours have T = (1, 0, 0) and (1, 1, 0).
  Mesh mesh = fan({{1, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}}, {{1, 0}, {0, 1}, {0, 2}, {-1, 1}});
  const TangentReport report = compute_tangents(mesh, TangentMethod::mikktspace);
  EXPECT_EQ(report.degenerate_triangles, 1U);
  EXPECT_EQ(report.split_vertices, 0U);
  expect_tangent(mesh, 0, 90.0 * glm::dvec3(1, 0, 0) + 45.0 * glm::normalize(glm::dvec3(1, 1, 0)));
}

TEST(Mikktspace, keeps_sides_of_a_texture_seam_apart) {
  // Two squares at x = 0 with one normal; the right one's texture is turned by a quarter.
  Mesh mesh;
  mesh.positions = {{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  mesh.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 3}, {0, 2}, {1, 2}, {1, 3}};
  mesh.normals.assign(8, {0, 0, 1});
  mesh.indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
  compute_tangents(mesh, TangentMethod::mikktspace);
  ASSERT_EQ(mesh.vertex_count(), 8U);
  for (std::size_t v = 0; v < 4; ++v) expect_tangent(mesh, v, {1, 0, 0});
  for (std::size_t v = 4; v < 8; ++v) expect_tangent(mesh, v, {0, 1, 0});
}

TEST(Tangents, of_a_sliver_of_texture_are_right_and_of_a_line_there_are_none) {
  // A thousandth of a texture's height, as on a long thin face: T and B are as exact as the numbers.
  Mesh sliver = fan({{1, 0, 0}, {1, 1, 0}}, {{1, 0}, {1, 0.001F}});
  EXPECT_EQ(compute_tangents(sliver, TangentMethod::gram_schmidt).degenerate_triangles, 0U);
  expect_tangent(sliver, 0, {1, 0, 0});
  // On a line, but not to the last bit: 0.1, 0.3 and 0.9 are no floats.
  Mesh line = fan({{1, 0, 0}, {1, 1, 0}}, {{0.1F, 0.3F}, {0.3F, 0.9F}});
  for (const TangentMethod method :
       {TangentMethod::averaged, TangentMethod::gram_schmidt, TangentMethod::angle_weighted}) {
    Mesh mesh = line;
    const TangentReport report = compute_tangents(mesh, method);
    EXPECT_EQ(report.degenerate_triangles, 1U);
    EXPECT_EQ(report.fallback_vertices, 3U);
  }
}

TEST(Tangents, of_a_mirrored_texture_say_so_in_the_sign) {
  for (const TangentMethod method : {TangentMethod::averaged, TangentMethod::gram_schmidt,
                                     TangentMethod::angle_weighted, TangentMethod::mikktspace})
    for (const float side : {1.0F, -1.0F}) {
      Mesh mesh = fan({{1, 0, 0}, {0, 1, 0}}, {{side, 0}, {0, 1}});
      compute_tangents(mesh, method);
      for (const glm::vec4& tangent : mesh.tangents) EXPECT_EQ(tangent, glm::vec4(side, 0, 0, side));
    }
}

TEST(AngleBetween, is_exact_for_slivers) {
  EXPECT_NEAR(angle_between({1, 0, 0}, {1, 1e-9, 0}), 1e-9, 1e-20);
  EXPECT_NEAR(angle_between({1, 0, 0}, {0, 2, 0}), 90 * degree, 1e-15);
}

}  // namespace
}  // namespace texel::mesh
