// SPDX-License-Identifier: MIT
// Tangents of a few triangles, worked out by hand: which triangles share one, by how much each of them
// counts, and what is there where none can be.
#include "mesh/tangents.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/meshes.hpp"
#include "core/error.hpp"
#include "mesh/primitives.hpp"

namespace texel::mesh {
namespace {

using glm::dvec3;
using test::degrees_between;
using Method = TangentMethod;

TEST(Orthonormalize, keeps_the_side_of_the_bitangent) {
  const glm::vec3 n(0, 0, 1);
  EXPECT_EQ(orthonormalize(n, {3, 0, 4}, {0, 1, 0}), glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(orthonormalize(n, {3, 0, 4}, {0, -1, 0}), glm::vec4(1, 0, 0, -1));
  EXPECT_EQ(orthonormalize(n, {0, 0, 4}, {0, 1, 0}), glm::vec4(0, 0, 0, 1)) << "no part in the plane";
}

TEST(TextureArea, is_zero_on_a_line_and_signed_elsewhere) {
  EXPECT_EQ(texture_area({{{0.1F, 0.2F}, {0.2F, 0.4F}, {0.3F, 0.6F}}}), 0.0);
  EXPECT_EQ(texture_area({{{0.3F, 0.3F}, {0.3F, 0.3F}, {1, 0}}}), 0.0);
  EXPECT_EQ(texture_area({{{0, 0}, {1, 0}, {0, 1}}}), 1.0);
  EXPECT_EQ(texture_area({{{0, 0}, {0, 1}, {1, 0}}}), -1.0);
  EXPECT_GT(texture_area({{{0, 0}, {1e-6F, 0}, {0, 1e-6F}}}), 0.0) << "small is not degenerate";
}

/// Triangles around vertex 0, which lies at the origin with texture coordinate (0, 0).
Mesh fan(const std::vector<glm::vec3>& around, const std::vector<glm::vec2>& texcoords) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}};
  mesh.texcoords = {{0, 0}};
  mesh.positions.insert(mesh.positions.end(), around.begin(), around.end());
  mesh.texcoords.insert(mesh.texcoords.end(), texcoords.begin(), texcoords.end());
  mesh.normals.assign(mesh.vertex_count(), {0, 0, 1});
  for (std::uint32_t i = 1; i + 1 < mesh.vertex_count(); ++i)
    mesh.indices.insert(mesh.indices.end(), {0, i, i + 1});
  return mesh;
}

/// A quarter turn with the texture straight, then an eighth where T, solved for by hand, is (1, 1/2, 0).
Mesh bent_fan() {
  return fan({{1, 0, 0}, {0, 1, 0}, {-1, 1, 0}}, {{1, 0}, {0, 1}, {-1, 1.5F}});
}

void expect_tangent(const Mesh& mesh, std::size_t vertex, const dvec3& direction) {
  EXPECT_LT(glm::distance(dvec3(mesh.tangents[vertex]), glm::normalize(direction)), 1e-6) << vertex;
}

TEST(Tangents, are_weighted_by_length_or_angle_and_lie_in_the_plane_of_the_vertex_normal) {
  const dvec3 first(1, 0, 0), second(1, 0.5, 0), x(1, 0, 0), y(0, 1, 0), corner(-1, 1, 0);
  for (const dvec3& n : {dvec3(0, 0, 1), dvec3(0.6, 0.3, 1)}) {
    const dvec3 normal = glm::normalize(n);
    const auto in_plane = [&](const dvec3& v) { return v - glm::dot(v, normal) * normal; };
    const auto unit = [&](const dvec3& v) { return glm::normalize(in_plane(v)); };
    const auto angle = [&](const dvec3& a, const dvec3& b) { return std::acos(glm::dot(unit(a), unit(b))); };
    const std::pair<Method, dvec3> rows[] = {
        {Method::averaged, first + second},
        {Method::gram_schmidt, in_plane(first + second)},
        {Method::angle_weighted, in_plane(90.0 * first + 45.0 * glm::normalize(second))},
        // Tangents and angles are those that are seen along the normal.
        {Method::mikktspace, angle(x, y) * unit(first) + angle(y, corner) * unit(second)}};
    for (const auto& [method, expected] : rows) {
      Mesh mesh = bent_fan();
      mesh.normals.assign(mesh.vertex_count(), glm::vec3(normal));
      compute_tangents(mesh, method);
      expect_tangent(mesh, 0, expected);
    }
  }
}

TEST(Tangents, follow_a_sheared_stretched_and_mirrored_texture) {
  // The texture's columns are (s, t) along x and along y.
  const std::tuple<glm::mat2, dvec3, dvec3, float> rows[] = {
      {{{1, 0}, {0, 1}}, {1, 0, 0}, {0, 1, 0}, 1},
      {{{-1, 0}, {0, 1}}, {-1, 0, 0}, {0, 1, 0}, -1},
      {{{1, 0}, {1, 4}}, {1, 0, 0}, {-1, 1, 0}, 1},
      // The slides' triangle: 71.57 degrees between T and B.
      {{{0.5F, 0.5F}, {-0.5F, 1}}, {2, -1, 0}, {1, 1, 0}, 1},
      // A thousandth of a texture's height, as on a long thin face: as exact as the numbers.
      {{{1, 0}, {0, 0.001F}}, {1, 0, 0}, {0, 1, 0}, 1}};
  for (const auto& [texture, tangent, bitangent, side] : rows)
    for (const Method method : test::tangent_methods) {
      Mesh mesh = quad(1.0F, 4);
      for (glm::vec2& st : mesh.texcoords) st = texture * st;
      compute_tangents(mesh, method);
      ASSERT_EQ(mesh.vertex_count(), 25U);
      EXPECT_EQ(mesh.bitangents.empty(), method != Method::averaged);
      for (std::size_t v = 0; v < 25; ++v) {
        expect_tangent(mesh, v, tangent);
        EXPECT_EQ(mesh.tangents[v].w, side);
        // The plain average's own B keeps the shear.
        if (method == Method::averaged) {
          EXPECT_LT(degrees_between(mesh.bitangents[v], bitangent), 1e-4);
        }
      }
    }
}

TEST(Tangents, do_not_depend_on_the_size_of_a_model) {
  const Mesh unit = torus(1.0F, 0.4F, 24, 12);
  for (const Method method : test::tangent_methods) {
    Mesh expected = unit;
    compute_tangents(expected, method);
    for (const float size : {1e-6F, 1e6F}) {
      Mesh mesh = unit;
      for (glm::vec3& p : mesh.positions) p *= size;
      compute_tangents(mesh, method);
      ASSERT_EQ(mesh.vertex_count(), expected.vertex_count());
      for (std::size_t v = 0; v < mesh.vertex_count(); ++v)  // float32 rounding of the scaled positions
        EXPECT_LT(degrees_between(mesh.tangents[v], expected.tangents[v]), 1e-3);
    }
  }
}

TEST(Tangents, are_split_where_the_texture_is_mirrored) {
  // Two squares side by side; the right one's s runs back, so that the texture is mirrored at x = 0.
  Mesh squares;
  squares.positions = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {0, 1, 0}, {1, 1, 0}};
  squares.texcoords = {{0, 0}, {1, 0}, {0, 0}, {0, 1}, {1, 1}, {0, 1}};
  squares.normals.assign(6, {0, 0, 1});
  squares.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  for (const Method method : test::tangent_methods) {
    Mesh mesh = squares;
    compute_tangents(mesh, method);
    if (method == Method::averaged) {
      EXPECT_EQ(mesh.vertex_count(), 6U);
      // Two triangles against one: on the other side of the mirror T points the wrong way.
      EXPECT_EQ(glm::vec3(mesh.tangents[1]), glm::vec3(-1, 0, 0));
      EXPECT_EQ(glm::vec3(mesh.tangents[4]), glm::vec3(1, 0, 0));
      continue;
    }
    ASSERT_EQ(mesh.vertex_count(), 8U);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      const float side = i < 6 ? 1.0F : -1.0F;
      EXPECT_EQ(mesh.tangents[mesh.indices[i]], glm::vec4(side, 0, 0, side)) << "corner " << i;
    }
  }
}

// ---- Where there is no tangent.

/// What MikkTSpace gives where it finds no tangent, whatever the normal.
constexpr glm::vec4 mikktspace_nothing{1.0F, 0.0F, 0.0F, -1.0F};

TEST(Tangents, ignore_degenerate_triangles_and_fall_back_where_there_is_nothing_else) {
  for (const Method method : test::tangent_methods) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}};
    // The second triangle has no area in the texture; the third is alone and has none either; the fourth has
    // none in space.
    mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}, {0.5F, 0.5F}, {0.3F, 0.3F}, {0.3F, 0.3F}, {0.3F, 0.3F}};
    mesh.normals.assign(7, glm::normalize(glm::vec3(1, 2, 3)));
    for (std::size_t v = 0; v < 4; ++v) mesh.normals[v] = {0, 0, 1};
    mesh.indices = {0, 1, 2, 2, 1, 3, 4, 5, 6, 0, 1, 1};
    compute_tangents(mesh, method);
    ASSERT_EQ(mesh.vertex_count(), 7U);
    for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(mesh.tangents[v], glm::vec4(1, 0, 0, 1));
    // MikkTSpace alone hands a neighbour's frame over the shared edge's ends, not to the far corner.
    for (std::size_t v = 3; v < 7; ++v)
      EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[v]), mesh.normals[v]), 0, 1e-6);
    if (method == Method::mikktspace) {
      EXPECT_EQ(mesh.tangents[3], mikktspace_nothing);
    }
  }
}

TEST(Tangents, of_a_line_in_the_texture_are_none_but_by_mikktspace) {
  // On a line, but not to the last bit: 0.1, 0.3 and 0.9 are no floats. To MikkTSpace's reference an area of
  // 1e-8 counts.
  for (const Method method : test::tangent_methods) {
    Mesh mesh = fan({{1, 0, 0}, {1, 1, 0}}, {{0.1F, 0.3F}, {0.3F, 0.9F}});
    compute_tangents(mesh, method);
    for (const glm::vec4& tangent : mesh.tangents)
      EXPECT_EQ(glm::vec3(tangent) == any_orthogonal({0, 0, 1}), method != Method::mikktspace);
  }
}

TEST(Tangents, make_a_frame_where_there_are_none_or_they_lie_along_the_normal) {
  // A face with one texture coordinate, as in models with a palette; and T along the normal, up to rounding.
  for (const bool has_texture : {false, true})
    for (const Method method : test::tangent_methods) {
      const bool leans = method == Method::averaged && has_texture;  // as T was given
      const bool mikktspace = method == Method::mikktspace && has_texture;
      for (const glm::vec3& n : {glm::vec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0.8F, 0, 0.6F}, {1, 0.01F, 0}}) {
        Mesh mesh;
        const glm::vec3 normal = glm::normalize(n), up = any_orthogonal(normal);
        mesh.positions = {{0, 0, 0}, has_texture ? 3.0F * n : glm::cross(up, normal), up};
        mesh.texcoords = {{0, 0}, {has_texture, 0}, {0, has_texture}};
        mesh.normals.assign(3, normal);
        mesh.indices = {0, 1, 2};
        compute_tangents(mesh, method);
        for (const glm::vec4& tangent : mesh.tangents) {
          EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1, 1e-6);
          const double sine = glm::length(glm::cross(dvec3(tangent), dvec3(normal)));
          EXPECT_GT(sine, leans ? -1 : mikktspace ? 1e-6 : 1 - 1e-6) << static_cast<int>(method);
        }
      }
    }
}

TEST(Tangents, say_what_is_missing) {
  Mesh mesh = test::icosphere(0);
  EXPECT_THROW(compute_tangents(mesh, Method::averaged), Error);
  mesh = quad();
  mesh.normals.clear();
  EXPECT_THROW(compute_tangents(mesh, Method::mikktspace), Error);
  Mesh empty;
  compute_tangents(empty, Method::mikktspace);
  EXPECT_TRUE(empty.tangents.empty());
}

// ---- MikkTSpace's groups.

TEST(Mikktspace, goes_through_a_triangle_without_texture_area) {
  // The middle triangle's texture is a line; its neighbours have T = (1, 0, 0) and (1, 1, 0).
  Mesh mesh = fan({{1, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0}}, {{1, 0}, {0, 1}, {0, 2}, {-1, 1}});
  compute_tangents(mesh, Method::mikktspace);
  ASSERT_EQ(mesh.vertex_count(), 5U);
  expect_tangent(mesh, 0, 90.0 * dvec3(1, 0, 0) + 45.0 * glm::normalize(dvec3(1, 1, 0)));
}

}  // namespace
}  // namespace texel::mesh
