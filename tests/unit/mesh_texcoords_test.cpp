// SPDX-License-Identifier: MIT
#include "mesh/texcoords.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/meshes.hpp"
#include "mesh/primitives.hpp"
#include "mesh/tangents.hpp"
#include "mesh/weld.hpp"
#include "steps.hpp"

namespace texel::mesh {
namespace {

using test::icosphere;
using test::plane_tangents;

/// Positions and triangles alone, vertices at one place joined.
Mesh bare(const Mesh& mesh) {
  Mesh result;
  result.positions = mesh.positions;
  result.indices = mesh.indices;
  return texel::weld(result);
}

std::array<glm::vec2, 3> texcoords_of(const Mesh& mesh, std::size_t triangle) {
  return {mesh.texcoords[mesh.indices[3 * triangle]], mesh.texcoords[mesh.indices[3 * triangle + 1]],
          mesh.texcoords[mesh.indices[3 * triangle + 2]]};
}

TEST(Texcoords, spherical_formula_puts_the_front_first_and_the_north_up) {
  struct Row {
    glm::vec3 direction;
    glm::vec2 st;
  };
  const Row rows[] = {
      {{0, 0, 1}, {0.0f, 0.5f}},   {{1, 0, 0}, {0.25f, 0.5f}},  {{0, 0, -1}, {0.5f, 0.5f}},
      {{-1, 0, 0}, {0.75f, 0.5f}}, {{0, 1, 0}, {0.0f, 1.0f}},   {{0, -1, 0}, {0.0f, 0.0f}},
      {{0, 0, 0}, {0.0f, 0.5f}},   {{2, 0, 2}, {0.125f, 0.5f}}, {{0, 3, 3}, {0.0f, 0.75f}},
  };
  for (const Row& row : rows)
    EXPECT_LT(glm::distance(spherical_texcoord(row.direction), row.st), 1e-6f) << row.st.s << ' ' << row.st.t;
}

TEST(Texcoords, spherical_ones_of_a_sphere_are_its_own) {
  const Mesh exact = sphere(12, 24);
  Mesh mesh = bare(exact);
  generate_texcoords(mesh, Projection::spherical);
  EXPECT_EQ(mesh.vertex_count(), exact.vertex_count()) << "seam and poles split as the primitive has them";
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const auto ours = texcoords_of(mesh, t), theirs = texcoords_of(exact, t);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_LT(glm::distance(ours[k], theirs[k]), 1e-6f);
  }
}

TEST(Texcoords, no_triangle_runs_back_across_the_texture) {
  for (const Projection projection : {Projection::cylindrical, Projection::spherical})
    for (const Mesh& shape : {sphere(12, 24), torus(1.0f, 0.3f, 24, 12), icosphere(3)}) {
      Mesh mesh = bare(shape);
      generate_texcoords(mesh, projection);
      for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const auto st = texcoords_of(mesh, t);
        const auto [least, greatest] = std::minmax({st[0].s, st[1].s, st[2].s});
        EXPECT_LE(greatest - least, 0.5f);
      }
    }
}

TEST(Texcoords, box_gives_a_cube_six_upright_copies) {
  const Mesh exact = cube_split(2.0f);
  Mesh mesh = bare(exact);
  ASSERT_EQ(mesh.vertex_count(), 8u);
  generate_texcoords(mesh, Projection::box);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
    EXPECT_EQ(texcoords_of(mesh, t), texcoords_of(exact, t));
}

TEST(Texcoords, planar_and_box_keep_texels_square_on_long_models) {
  for (const Projection projection : {Projection::planar, Projection::box}) {
    Mesh mesh = bare(quad(1.0f));
    for (glm::vec3& p : mesh.positions) p = p * glm::vec3(3.0f, 1.0f, 1.0f) + glm::vec3(100.0f, 0.0f, -7.0f);
    generate_texcoords(mesh, projection);
    EXPECT_EQ(mesh.vertex_count(), 4u);
    EXPECT_LT(glm::distance(mesh.texcoords[0], glm::vec2(0.0f, 1.0f / 3.0f)), 1e-6f);  // float32 of 1/2 - 1/6
    EXPECT_LT(glm::distance(mesh.texcoords[1], glm::vec2(1.0f, 1.0f / 3.0f)), 1e-6f);
  }
}

TEST(Texcoords, are_finite_for_any_mesh) {
  Mesh flat;
  flat.positions = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {2, 1, 1}, {3, 1, 1}};
  flat.indices = {0, 1, 2, 0, 3, 4};
  Mesh huge = icosphere(1, 1e37f), tiny = icosphere(1, 1e-30f);
  for (const Projection projection :
       {Projection::planar, Projection::box, Projection::cylindrical, Projection::spherical})
    for (Mesh mesh : {flat, huge, tiny, Mesh{}}) {
      generate_texcoords(mesh, projection);
      EXPECT_EQ(mesh.texcoords.size(), mesh.vertex_count());
      for (const glm::vec2& st : mesh.texcoords) EXPECT_TRUE(std::isfinite(st.s) && std::isfinite(st.t));
    }
}

TEST(TextureLayout, leans_squeezes_and_turns_s_round) {
  Mesh mesh = quad();
  plane_tangents(mesh);
  lay_texture(mesh, {.shear = 1, .stretch = 4, .mirror = true});
  // The corners (0, 0), (1, 0), (0, 1), (1, 1): s = 1 - 4 (s + t).
  EXPECT_EQ(mesh.texcoords, (std::vector<glm::vec2>{{1, 0}, {-3, 0}, {-3, 1}, {-7, 1}}));
  EXPECT_EQ(mesh.tangents[0], glm::vec4(-1, 0, 0, -1)) << "T along growing s, and left-handed";
  Mesh same = quad();
  lay_texture(same, {});
  EXPECT_EQ(same.texcoords, quad().texcoords);
}

}  // namespace
}  // namespace texel::mesh
