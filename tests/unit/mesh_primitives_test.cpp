// SPDX-License-Identifier: MIT
#include "mesh/primitives.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "../support/meshes.hpp"
#include "mesh/bounds.hpp"
#include "mesh/normals.hpp"
#include "mesh/tangents.hpp"
#include "mesh/vectors.hpp"
#include "mesh/weld.hpp"
#include "steps.hpp"

namespace texel::mesh {
namespace {

using test::icosphere;
using test::plane_tangents;

/// Every triangle runs counter-clockwise seen from the side of its normals, and its texture is not mirrored.
void expect_outward(const Mesh& mesh, bool with_texcoords = true) {
  ASSERT_EQ(mesh.normals.size(), mesh.vertex_count());
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
    const glm::vec3 face = face_normal(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
    EXPECT_GT(glm::dot(face, mesh.normals[a] + mesh.normals[b] + mesh.normals[c]), 0.0f)
        << "triangle " << i / 3;
    if (with_texcoords) {
      EXPECT_GT(texture_area({mesh.texcoords[a], mesh.texcoords[b], mesh.texcoords[c]}), 0.0);
    }
  }
}

/// Each edge is used once in each direction when vertices at the same place count as one.
void expect_closed(const Mesh& mesh) {
  Mesh bare;
  bare.positions = mesh.positions;
  bare.indices = mesh.indices;
  bare = texel::weld(bare);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (std::size_t i = 0; i < bare.indices.size(); ++i) {
    const std::size_t next = i % 3 == 2 ? i - 2 : i + 1;
    ++edges[{bare.indices[i], bare.indices[next]}];
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

TEST(Primitives, have_the_counts_that_their_parameters_give) {
  EXPECT_EQ(quad().vertex_count(), 4u);
  EXPECT_EQ(quad().triangle_count(), 2u);
  EXPECT_EQ(grid(1.0f, 5).vertex_count(), 36u);
  EXPECT_EQ(cube_split().vertex_count(), 24u);
  EXPECT_EQ(cube_split().triangle_count(), 12u);
  EXPECT_EQ(sphere(8, 12).triangle_count(), 2u * 12 * 7);
  EXPECT_EQ(sphere(8, 12).vertex_count(), 13u * 7 + 2 * 12);
  EXPECT_EQ(torus(1.0f, 0.3f, 16, 8).vertex_count(), 17u * 9);
  EXPECT_EQ(icosphere(3).vertex_count(), 10u * 64 + 2);
  EXPECT_EQ(icosphere(3).triangle_count(), 20u * 64);
  EXPECT_EQ(sphere(-5, 0).triangle_count(), 6u) << "the least that makes a surface";
}

TEST(Primitives, face_outward_with_the_texture_upright) {
  for (const Mesh& mesh : {quad(), grid(2.0f, 3), cube_split(), sphere(7, 9), torus(1.0f, 0.4f, 11, 7),
                           torus(1.0f, 0.4f, 11, 7, {0.49f, 3}), sphere(7, 9, 1.0f, {0.49f, 3}),
                           grid(2.0f, 5, {0.49f, 3}), cube_split(1.0f, 4, {0.49f, 3})})
    expect_outward(mesh);
  expect_outward(icosphere(2), false);
}

TEST(Primitives, are_closed) {
  expect_closed(cube_split());
  expect_closed(sphere(7, 9));
  expect_closed(torus(1.0f, 0.4f, 11, 7));
  // Sliding vertices stay together at edges, seams and poles.
  expect_closed(cube_split(1.0f, 4, {0.5f, 1}));
  expect_closed(sphere(7, 9, 1.0f, {0.5f, 1}));
  expect_closed(torus(1.0f, 0.4f, 11, 7, {0.5f, 1}));
  expect_closed(icosphere(2));
}

TEST(Primitives, sphere_lies_where_its_texture_coordinates_say_jittered_or_not) {
  for (const float amount : {0.0f, 0.8f}) {
    const Mesh mesh = sphere(10, 16, 2.0f, {amount, 11});
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      const glm::dvec2 st(mesh.texcoords[v]);
      const double lat = std::numbers::pi * (st.t - 0.5), lon = 2.0 * std::numbers::pi * st.s;
      const glm::dvec3 expected(std::cos(lat) * std::sin(lon), std::sin(lat), std::cos(lat) * std::cos(lon));
      // s and t are rounded to float32: 2 pi * 2^-24 of a turn, times the radius 2.
      EXPECT_LT(glm::distance(glm::dvec3(mesh.positions[v]), 2.0 * expected), 1e-6);
      EXPECT_LT(glm::distance(glm::dvec3(mesh.normals[v]), expected), 5e-7);
    }
  }
}

TEST(Primitives, torus_lies_where_its_texture_coordinates_say_jittered_or_not) {
  for (const float amount : {0.0f, 0.8f}) {
    const Mesh mesh = torus(1.5f, 0.5f, 24, 12, {amount, 11});
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      const double a = 2.0 * std::numbers::pi * double(mesh.texcoords[v].s);
      const double b = 2.0 * std::numbers::pi * double(mesh.texcoords[v].t);
      const glm::dvec3 normal(std::cos(b) * std::sin(a), std::sin(b), std::cos(b) * std::cos(a));
      const glm::dvec3 position = 1.5 * glm::dvec3(std::sin(a), 0.0, std::cos(a)) + 0.5 * normal;
      EXPECT_LT(glm::distance(glm::dvec3(mesh.positions[v]), position), 2e-6);  // as for the sphere, radius 2
      EXPECT_LT(glm::distance(glm::dvec3(mesh.normals[v]), normal), 1e-6);
    }
  }
}

TEST(Primitives, jitter_is_the_same_for_the_same_seed_only) {
  const Mesh a = torus(1.0f, 0.4f, 9, 6, {0.5f, 1}), b = torus(1.0f, 0.4f, 9, 6, {0.5f, 1});
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_NE(a.positions, torus(1.0f, 0.4f, 9, 6, {0.5f, 2}).positions);
  EXPECT_EQ(a.positions.front(), a.positions.back()) << "both copies of the seam's corner";
}

TEST(Primitives, jitter_slides_the_inner_vertices_of_a_plane_alone) {
  const Mesh even = grid(1.0f, 4), rough = grid(1.0f, 4, {0.5f, 1});
  int moved = 0;
  for (std::size_t v = 0; v < even.vertex_count(); ++v) {
    const glm::vec2 here(rough.positions[v]), st = rough.texcoords[v];
    EXPECT_LT(glm::distance(here, 2.0f * st - 1.0f), 1e-6f) << "the place that its texture coordinate says";
    const glm::vec2 way = glm::abs(here - glm::vec2(even.positions[v]));
    EXPECT_LE(std::max(way.x, way.y), 0.125f) << "a quarter of a cell of 1/2";
    if (way != glm::vec2(0.0f)) ++moved;
  }
  EXPECT_EQ(moved, 3 * 3);
}

TEST(Primitives, exact_tangents_follow_growing_s) {
  Mesh mesh = torus(1.0f, 0.4f, 256, 8);
  revolution_tangents(mesh);
  for (std::size_t v = 0; v + 1 < 256; ++v) {
    const glm::vec3 step = unit_or_zero(mesh.positions[v + 1] - mesh.positions[v]);
    // A chord of 1/256 of a turn leaves its circle's tangent by 0.70 degrees: cosine 0.99992.
    EXPECT_GT(glm::dot(glm::vec3(mesh.tangents[v]), step), 0.9999f);
  }
  Mesh flat = grid(1.0f, 2);
  plane_tangents(flat);
  EXPECT_EQ(flat.tangents[4], glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
}

TEST(Bounds, center_and_unit_size_hold_for_models_of_any_size_and_place) {
  for (const float size : {1e-6f, 1.0f, 1e6f}) {
    Mesh mesh = sphere(16, 32, size);
    for (glm::vec3& p : mesh.positions) p += glm::vec3(3.0f * size, -size, 0.0f);
    normalize_to_unit(mesh);
    const Bounds box = bounds(mesh);
    EXPECT_LT(glm::length(box.center()), 1e-6f);  // float32 offsets of three radii
    float farthest = 0.0f;
    for (const glm::vec3& p : mesh.positions) farthest = std::max(farthest, glm::length(p));
    EXPECT_NEAR(farthest, 1.0f, 1e-6f);
  }
  Mesh point;
  point.positions = {{5.0f, 5.0f, 5.0f}};
  normalize_to_unit(point);
  EXPECT_EQ(point.positions[0], glm::vec3(0.0f));
  Mesh empty;
  normalize_to_unit(empty);
  EXPECT_EQ(bounds(empty).extent(), glm::vec3(0.0f));
}

}  // namespace
}  // namespace texel::mesh
