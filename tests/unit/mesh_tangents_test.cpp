// SPDX-License-Identifier: MIT
#include "mesh/tangents.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/meshes.hpp"
#include "core/error.hpp"
#include "mesh/distinct.hpp"
#include "mesh/normals.hpp"
#include "mesh/primitives.hpp"
#include "mesh/vectors.hpp"
#include "mesh/weld.hpp"

namespace texel::mesh {
namespace {

using test::icosphere;
using test::plane_tangents;

constexpr TangentMethod all_methods[] = {TangentMethod::averaged, TangentMethod::gram_schmidt,
                                         TangentMethod::angle_weighted, TangentMethod::mikktspace};

double degrees_between(const glm::vec3& a, const glm::vec3& b) {
  return glm::degrees(angle_between(glm::dvec3(a), glm::dvec3(b)));
}

/// The largest angle between the method's tangents and the exact ones that lie in `exact.tangents`.
double worst_degrees(const Mesh& exact, TangentMethod method) {
  Mesh mesh = exact;
  compute_tangents(mesh, method);
  EXPECT_EQ(mesh.vertex_count(), exact.vertex_count()) << "nothing to split";
  double worst = 0.0;
  for (std::size_t v = 0; v < exact.vertex_count(); ++v) {
    EXPECT_EQ(mesh.tangents[v].w, 1.0f);
    worst = std::max(worst, degrees_between(glm::vec3(mesh.tangents[v]), glm::vec3(exact.tangents[v])));
  }
  return worst;
}

/// What MikkTSpace gives where it finds no tangent, whatever the normal.
constexpr glm::vec4 mikktspace_nothing{1.0f, 0.0f, 0.0f, -1.0f};

void expect_usable(const Mesh& mesh, TangentMethod method) {
  ASSERT_EQ(mesh.tangents.size(), mesh.vertex_count());
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const glm::vec4& t = mesh.tangents[v];
    EXPECT_NEAR(glm::length(glm::vec3(t)), 1.0f, 1e-6f) << "vertex " << v;
    EXPECT_EQ(std::abs(t.w), 1.0f);
    const bool may_lean =
        method == TangentMethod::averaged || (method == TangentMethod::mikktspace && t == mikktspace_nothing);
    if (!may_lean) {
      // A T that is nearly along n loses digits in the projection: 1.1e-6 was measured.
      EXPECT_NEAR(glm::dot(glm::vec3(t), mesh.normals[v]), 0.0f, 2e-6f) << "vertex " << v;
    }
  }
}

/// Two squares side by side; the right one's s runs back, so that the texture is mirrored at x = 0.
Mesh mirrored_squares() {
  Mesh mesh;
  mesh.positions = {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}, {-1, 1, 0}, {0, 1, 0}, {1, 1, 0}};
  mesh.texcoords = {{0, 0}, {1, 0}, {0, 0}, {0, 1}, {1, 1}, {0, 1}};
  mesh.normals.assign(6, {0, 0, 1});
  mesh.indices = {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4};
  return mesh;
}

TEST(TriangleFrame, solves_the_slides_equations) {
  const std::array<glm::vec3, 3> p{{{1, 2, 3}, {2, 2.5f, 3}, {0.5f, 4, 2}}};
  const std::array<glm::vec2, 3> uv{{{0.5f, 0}, {1, 0.5f}, {0, 1}}};  // the slides' triangle
  const TriangleFrame frame = triangle_frame(p, uv);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const glm::vec2 d = uv[next] - uv[k];
    // Exact but for float32 rounding of numbers near 4.
    EXPECT_LT(glm::distance(p[next] - p[k], d.s * frame.tangent + d.t * frame.bitangent), 1e-6f);
  }
}

TEST(TriangleFrame, is_as_long_as_the_texture_is_wide_and_high) {
  const TriangleFrame frame =
      triangle_frame({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, {{{0, 0}, {0.25f, 0}, {0, 2}}});
  EXPECT_EQ(frame.tangent, glm::vec3(4, 0, 0));
  EXPECT_EQ(frame.bitangent, glm::vec3(0, 0.5f, 0));
}

TEST(Orthonormalize, keeps_the_side_of_the_bitangent) {
  const glm::vec3 n(0, 0, 1);
  EXPECT_EQ(orthonormalize(n, {3, 0, 4}, {0, 1, 0}), glm::vec4(1, 0, 0, 1));
  EXPECT_EQ(orthonormalize(n, {3, 0, 4}, {0, -1, 0}), glm::vec4(1, 0, 0, -1));
  EXPECT_EQ(orthonormalize(n, {0, 0, 4}, {0, 1, 0}), glm::vec4(0, 0, 0, 1)) << "no part in the plane";
}

TEST(TextureArea, is_zero_on_a_line_and_signed_elsewhere) {
  EXPECT_EQ(texture_area({{{0.1f, 0.2f}, {0.2f, 0.4f}, {0.3f, 0.6f}}}), 0.0);
  EXPECT_EQ(texture_area({{{0.3f, 0.3f}, {0.3f, 0.3f}, {1, 0}}}), 0.0);
  EXPECT_EQ(texture_area({{{0, 0}, {1, 0}, {0, 1}}}), 1.0);
  EXPECT_EQ(texture_area({{{0, 0}, {0, 1}, {1, 0}}}), -1.0);
  EXPECT_GT(texture_area({{{0, 0}, {1e-6f, 0}, {0, 1e-6f}}}), 0.0) << "small is not degenerate";
}

TEST(Tangents, are_exact_on_a_plane_by_every_method) {
  Mesh exact = grid(1.0f, 4);
  plane_tangents(exact);
  // 5e-6 degrees is one unit in the last place.
  for (const TangentMethod method : all_methods) EXPECT_LT(worst_degrees(exact, method), 1e-5);
}

TEST(Tangents, follow_a_sheared_and_stretched_texture) {
  for (const TangentMethod method : all_methods) {
    Mesh mesh = grid(1.0f, 4);
    // 45 degrees of shear and 4:1: s = x + y, t = 4 y, so T = +x and B = (-1, 1) / 4.
    for (glm::vec2& st : mesh.texcoords) st = {st.s + st.t, 4.0f * st.t};
    compute_tangents(mesh, method);
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
      EXPECT_LT(degrees_between(glm::vec3(mesh.tangents[v]), {1, 0, 0}), 1e-4);
      if (method == TangentMethod::averaged) {
        EXPECT_LT(degrees_between(mesh.bitangents[v], {-1, 1, 0}), 1e-4) << "its own B keeps the shear";
      } else {
        EXPECT_TRUE(mesh.bitangents.empty());
      }
    }
  }
}

TEST(Tangents, come_near_the_exact_ones_on_curved_surfaces) {
  Mesh ball = sphere(32, 64), ring = torus(1.0f, 0.4f, 64, 32), rough = torus(1.0f, 0.4f, 64, 32, {0.5f, 5});
  for (Mesh* mesh : {&ball, &ring, &rough}) revolution_tangents(*mesh);
  struct Row {
    const char* name;
    const Mesh& exact;
    TangentMethod method;
    // Degrees. At the seam a vertex has triangles on one side only, so T is that of half a step further on:
    // 360 / 64 / 2 = 2.8125 degrees. On the jittered torus: just above what was measured.
    double limit;
  };
  const Row rows[] = {
      {"sphere averaged", ball, TangentMethod::averaged, 2.82},
      {"sphere gram_schmidt", ball, TangentMethod::gram_schmidt, 2.82},
      {"sphere angle_weighted", ball, TangentMethod::angle_weighted, 2.82},
      {"sphere mikktspace", ball, TangentMethod::mikktspace, 2.82},
      {"torus averaged", ring, TangentMethod::averaged, 2.82},
      {"torus gram_schmidt", ring, TangentMethod::gram_schmidt, 2.82},
      {"torus angle_weighted", ring, TangentMethod::angle_weighted, 2.82},
      {"torus mikktspace", ring, TangentMethod::mikktspace, 2.82},
      {"jittered averaged", rough, TangentMethod::averaged, 4.6},
      {"jittered gram_schmidt", rough, TangentMethod::gram_schmidt, 3.7},
      {"jittered angle_weighted", rough, TangentMethod::angle_weighted, 3.7},
      {"jittered mikktspace", rough, TangentMethod::mikktspace, 3.7},
  };
  for (const Row& row : rows) {
    const double worst = worst_degrees(row.exact, row.method);
    EXPECT_LT(worst, row.limit) << row.name;
  }
}

TEST(Tangents, error_shrinks_with_the_triangles) {
  // The slides: "if the triangles are small, the error is small". Half the size, half the error (seam:
  // one-sided).
  double before = 0.0;
  for (const int n : {16, 32, 64, 128}) {
    Mesh exact = torus(1.0f, 0.4f, 2 * n, n);
    revolution_tangents(exact);
    const double now = worst_degrees(exact, TangentMethod::gram_schmidt);
    if (before > 0.0) {
      EXPECT_NEAR(before / now, 2.0, 0.2);
    }
    before = now;
  }
}

TEST(Tangents, do_not_depend_on_the_size_and_place_of_a_model) {
  Mesh unit = torus(1.0f, 0.4f, 24, 12);
  for (const TangentMethod method : all_methods) {
    Mesh expected = unit;
    compute_tangents(expected, method);
    for (const float size : {1e-6f, 1e6f}) {
      Mesh mesh = unit;
      for (glm::vec3& p : mesh.positions) p *= size;
      compute_tangents(mesh, method);
      ASSERT_EQ(mesh.vertex_count(), expected.vertex_count());
      for (std::size_t v = 0; v < mesh.vertex_count(); ++v)  // float32 rounding of the scaled positions
        EXPECT_LT(degrees_between(glm::vec3(mesh.tangents[v]), glm::vec3(expected.tangents[v])), 1e-3);
    }
  }
}

TEST(Tangents, are_split_where_the_texture_is_mirrored) {
  for (const TangentMethod method : all_methods) {
    Mesh mesh = mirrored_squares();
    const TangentReport report = compute_tangents(mesh, method);
    expect_usable(mesh, method);
    if (method == TangentMethod::averaged) {
      EXPECT_EQ(mesh.vertex_count(), 6u);
      // Two triangles against one: on the other side of the mirror T points the wrong way.
      EXPECT_EQ(glm::vec3(mesh.tangents[1]), glm::vec3(-1, 0, 0));
      EXPECT_EQ(glm::vec3(mesh.tangents[4]), glm::vec3(1, 0, 0));
      continue;
    }
    EXPECT_EQ(report.split_vertices, 2u);
    EXPECT_EQ(report.fallback_vertices, 0u);
    EXPECT_EQ(mesh.vertex_count(), 8u);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
      const float side = i < 6 ? 1.0f : -1.0f;
      EXPECT_EQ(mesh.tangents[mesh.indices[i]], glm::vec4(side, 0, 0, side)) << "corner " << i;
    }
  }
}

TEST(Tangents, ignore_degenerate_triangles_and_fall_back_where_there_is_nothing_else) {
  for (const TangentMethod method : all_methods) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}};
    // The second triangle has no area in the texture; the third is alone and has none either; the fourth has
    // none in space.
    mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}, {0.5f, 0.5f}, {0.3f, 0.3f}, {0.3f, 0.3f}, {0.3f, 0.3f}};
    mesh.normals.assign(7, glm::normalize(glm::vec3(1, 2, 3)));
    for (std::size_t v = 0; v < 4; ++v) mesh.normals[v] = {0, 0, 1};
    mesh.indices = {0, 1, 2, 2, 1, 3, 4, 5, 6, 0, 1, 1};
    const TangentReport report = compute_tangents(mesh, method);
    EXPECT_EQ(report.degenerate_triangles, 3u);
    EXPECT_EQ(report.split_vertices, 0u);
    expect_usable(mesh, method);
    for (std::size_t v = 0; v < 3; ++v) EXPECT_EQ(mesh.tangents[v], glm::vec4(1, 0, 0, 1));
    // MikkTSpace alone hands a neighbour's frame over the shared edge's ends, not to the far corner.
    EXPECT_EQ(report.fallback_vertices, 4u);
    for (std::size_t v = 3; v < 7; ++v)
      EXPECT_NEAR(glm::dot(glm::vec3(mesh.tangents[v]), mesh.normals[v]), 0, 1e-6);
    if (method == TangentMethod::mikktspace) {
      EXPECT_EQ(mesh.tangents[3], mikktspace_nothing);
    }
  }
}

TEST(Tangents, make_a_frame_where_there_are_none_or_they_lie_along_the_normal) {
  // A face with one texture coordinate, as in models with a palette; and T along the normal, up to rounding.
  for (const bool has_texture : {false, true})
    for (const TangentMethod method : all_methods) {
      const bool leans = method == TangentMethod::averaged && has_texture;  // as T was given
      const bool mikktspace = method == TangentMethod::mikktspace;
      for (const glm::vec3& n : {glm::vec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0.8f, 0, 0.6f}, {1, 0.01f, 0}}) {
        Mesh mesh;
        const glm::vec3 normal = glm::normalize(n), up = any_orthogonal(normal);
        mesh.positions = {{0, 0, 0}, has_texture ? 3.0f * n : glm::cross(up, normal), up};
        mesh.texcoords = {{0, 0}, {has_texture, 0}, {0, has_texture}};
        mesh.normals.assign(3, normal);
        mesh.indices = {0, 1, 2};
        const TangentReport report = compute_tangents(mesh, method);
        EXPECT_TRUE(report.fallback_vertices == 3 || leans || (mikktspace && has_texture));
        for (const glm::vec4& tangent : mesh.tangents) {
          EXPECT_NEAR(glm::length(glm::vec3(tangent)), 1, 1e-6);
          const double sine = glm::length(glm::cross(glm::dvec3(tangent), glm::dvec3(normal)));
          EXPECT_GT(sine, leans                       ? -1
                          : mikktspace && has_texture ? 1e-6
                                                      : 1 - 1e-6)
              << static_cast<int>(method);
        }
      }
    }
}

TEST(Tangents, are_usable_on_a_heap_of_random_triangles) {
  std::uint64_t state = 1;
  const auto number = [&state](int steps) {
    return static_cast<float>((state = mix(state)) % static_cast<unsigned>(steps));
  };
  for (const TangentMethod method : all_methods) {
    Mesh mesh;
    for (int v = 0; v < 60; ++v) {  // few different values: many coincide, many triangles are degenerate
      mesh.positions.emplace_back(number(3), number(3), number(3));
      mesh.texcoords.emplace_back(number(3), number(3));
    }
    for (int i = 0; i < 600; ++i) mesh.indices.push_back(static_cast<std::uint32_t>(number(60)));
    smooth_normals(mesh, Weighting::angle);
    compute_tangents(mesh, method);
    expect_usable(mesh, method);
    EXPECT_EQ(mesh.indices.size(), 600u);
  }
}

TEST(Mikktspace, gives_separate_triangles_the_tangents_of_the_indexed_mesh) {
  const Mesh whole = torus(1.0f, 0.4f, 20, 10, {0.5f, 2});
  Mesh indexed = whole, soup = split(whole);
  compute_tangents(indexed, TangentMethod::mikktspace);
  compute_tangents(soup, TangentMethod::mikktspace);
  for (std::size_t i = 0; i < whole.indices.size(); ++i)
    EXPECT_EQ(soup.tangents[soup.indices[i]], indexed.tangents[indexed.indices[i]]);
}

TEST(Mikktspace, splits_fans_that_meet_only_at_a_point) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  mesh.texcoords = {
      {0, 0}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}};  // the second one's texture is turned by 90 degrees
  mesh.normals.assign(5, {0, 0, 1});
  mesh.indices = {0, 1, 2, 0, 3, 4};
  const TangentReport report = compute_tangents(mesh, TangentMethod::mikktspace);
  EXPECT_EQ(report.split_vertices, 1u);
  EXPECT_LT(degrees_between(glm::vec3(mesh.tangents[mesh.indices[0]]), {1, 0, 0}), 1e-4);
  EXPECT_LT(degrees_between(glm::vec3(mesh.tangents[mesh.indices[3]]), {0, 1, 0}), 1e-4);
}

TEST(Mikktspace, weighs_by_the_angle_in_the_plane_of_the_normal) {
  // A fan of two triangles whose T differ, at a corner of 90 and of 45 degrees.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 0}};
  mesh.texcoords = {{0, 0}, {1, 0}, {0, 1}, {-1, 0.5f}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.indices = {0, 1, 2, 0, 2, 3};
  const TriangleFrame second = triangle_frame({mesh.positions[0], mesh.positions[2], mesh.positions[3]},
                                              {mesh.texcoords[0], mesh.texcoords[2], mesh.texcoords[3]});
  const glm::vec3 expected = glm::normalize(2.0f * glm::vec3(1, 0, 0) + glm::normalize(second.tangent));
  compute_tangents(mesh, TangentMethod::mikktspace);
  EXPECT_LT(degrees_between(glm::vec3(mesh.tangents[0]), expected), 1e-4);
}

TEST(Tangents, say_what_is_missing) {
  Mesh mesh = icosphere(0);
  EXPECT_THROW(compute_tangents(mesh, TangentMethod::averaged), Error);
  mesh = quad();
  mesh.normals.clear();
  EXPECT_THROW(compute_tangents(mesh, TangentMethod::mikktspace), Error);
  Mesh empty;
  EXPECT_EQ(compute_tangents(empty, TangentMethod::mikktspace).degenerate_triangles, 0u);
}

}  // namespace
}  // namespace texel::mesh
