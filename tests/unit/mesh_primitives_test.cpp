// SPDX-License-Identifier: MIT
#include "mesh/primitives.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "../support/bare_mesh.hpp"
#include "../support/meshes.hpp"
#include "mesh/normals.hpp"
#include "steps.hpp"
#include "truth/surface.hpp"

namespace texel::mesh {
namespace {

using cube_wrap::face_normal;

using test::icosphere;

TEST(Primitives, have_the_counts_that_their_parameters_give) {
  const std::tuple<Mesh, std::size_t, std::size_t> rows[] = {
      {quad(), 4, 2},
      {quad(1.0F, 5), 36, 50},
      {cube_split(), 24, 12},
      {sphere(8, 12), 13 * 7 + 2 * 12, 2 * 12 * 7},
      {torus(1.0F, 0.3F, 16, 8), 17 * 9, 2 * 16 * 8},
      {icosphere(3), 10 * 64 + 2, 20 * 64},
      {sphere(-5, 0), 4 + 2 * 3, 6}};  // the least that makes a surface
  for (const auto& [mesh, vertices, triangles] : rows) {
    EXPECT_EQ(mesh.vertex_count(), vertices);
    EXPECT_EQ(mesh.triangle_count(), triangles);
  }
}

/// Every triangle runs counter-clockwise seen from the side of its normals, and its texture is not mirrored.
void expect_outward(const Mesh& mesh) {
  ASSERT_EQ(mesh.normals.size(), mesh.vertex_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto [a, b, c] = of_triangle(mesh, mesh.positions, t);
    const auto [na, nb, nc] = of_triangle(mesh, mesh.normals, t);
    EXPECT_GT(glm::dot(face_normal(a, b, c), na + nb + nc), 0.0F) << "triangle " << t;
    if (!mesh.texcoords.empty()) {
      EXPECT_GT(texture_area(of_triangle(mesh, mesh.texcoords, t)), 0.0);
    }
  }
}

/// Each edge is used once in each direction when vertices at the same place count as one.
void expect_closed(const Mesh& mesh) {
  const Mesh joined = test::bare(mesh);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t i = 0; i < joined.indices.size(); ++i)
    ++edges[{joined.indices[i], joined.indices[i % 3 == 2 ? i - 2 : i + 1]}];
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

TEST(Primitives, face_outward_with_the_texture_upright_and_are_closed) {
  for (const Mesh& mesh : {quad(), quad(2.0F, 3), quad(2.0F, 5, {0.49F, 3})}) expect_outward(mesh);
  // Sliding vertices stay together at edges, seams and poles.
  for (const Mesh& mesh :
       {cube_split(), sphere(7, 9), torus(1.0F, 0.4F, 11, 7), torus(1.0F, 0.4F, 11, 7, {0.49F, 3}),
        sphere(7, 9, 1.0F, {0.49F, 3}), cube_split(1.0F, 4, {0.49F, 3}), icosphere(2)}) {
    expect_outward(mesh);
    expect_closed(mesh);
  }
}

TEST(Primitives, lie_where_their_texture_coordinates_say_jittered_or_not) {
  for (const float amount : {0.0F, 0.8F}) {
    const std::pair<Mesh, truth::Surface> rows[] = {
        {sphere(10, 16, 2.0F, {amount, 11}), truth::sphere(2)},
        {torus(1.5F, 0.5F, 24, 12, {amount, 11}), truth::torus(1.5, 0.5)}};
    for (const auto& [mesh, surface] : rows)
      for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        const truth::SurfacePoint exact = surface(mesh.texcoords[v]);
        // s and t are rounded to float32: 2 pi * 2^-24 of a turn, times the radius 2; of the torus both
        // count.
        EXPECT_LT(glm::distance(glm::dvec3(mesh.positions[v]), exact.position), 2e-6);
        EXPECT_LT(glm::distance(glm::dvec3(mesh.normals[v]), exact.normal), 1e-6);
      }
  }
}

TEST(Primitives, jitter_slides_the_inner_vertices_of_a_plane_alone) {
  const Mesh even = quad(1.0F, 4), rough = quad(1.0F, 4, {0.5F, 1});
  int moved = 0;
  for (std::size_t v = 0; v < even.vertex_count(); ++v) {
    const glm::vec2 here(rough.positions[v]), st = rough.texcoords[v];
    EXPECT_LT(glm::distance(here, 2.0F * st - 1.0F), 1e-6F) << "the place that its texture coordinate says";
    const glm::vec2 way = glm::abs(here - glm::vec2(even.positions[v]));
    EXPECT_LE(std::max(way.x, way.y), 0.125F) << "a quarter of a cell of 1/2";
    if (way != glm::vec2(0.0F)) ++moved;
  }
  EXPECT_EQ(moved, 3 * 3);
}

TEST(Primitives, exact_tangents_follow_growing_s) {
  Mesh mesh = torus(1.0F, 0.4F, 256, 8);
  revolution_tangents(mesh);
  for (std::size_t v = 0; v + 1 < 256; ++v) {
    const glm::vec3 step = unit_or_zero(mesh.positions[v + 1] - mesh.positions[v]);
    // A chord of 1/256 of a turn leaves its circle's tangent by 0.70 degrees: cosine 0.99992.
    EXPECT_GT(glm::dot(glm::vec3(mesh.tangents[v]), step), 0.9999F);
  }
}

}  // namespace
}  // namespace texel::mesh
