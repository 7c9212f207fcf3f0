// SPDX-License-Identifier: MIT
#include "mesh/texcoords.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/bare_mesh.hpp"
#include "../support/meshes.hpp"
#include "mesh/primitives.hpp"

namespace texel::mesh {
namespace {

using test::icosphere;

Mesh laid_out(Mesh mesh, Projection projection) {
  generate_texcoords(mesh, projection);
  return mesh;
}

TEST(Texcoords, spherical_formula_puts_the_front_first_and_the_north_up) {
  const std::pair<glm::vec3, glm::vec2> rows[] = {
      {{0, 0, 1}, {0.0F, 0.5F}},   {{1, 0, 0}, {0.25F, 0.5F}},  {{0, 0, -1}, {0.5F, 0.5F}},
      {{-1, 0, 0}, {0.75F, 0.5F}}, {{0, 1, 0}, {0.0F, 1.0F}},   {{0, -1, 0}, {0.0F, 0.0F}},
      {{0, 0, 0}, {0.0F, 0.5F}},   {{2, 0, 2}, {0.125F, 0.5F}}, {{0, 3, 3}, {0.0F, 0.75F}},
  };
  for (const auto& [direction, st] : rows)
    EXPECT_LT(glm::distance(spherical_texcoord(direction), st), 1e-6F) << st.s << ' ' << st.t;
}

TEST(Texcoords, of_a_sphere_a_cylinder_a_cube_and_a_square_are_their_own) {
  Mesh tube = sphere(12, 24);  // of any height, the cylinder fills it
  for (std::size_t v = 0; v < tube.vertex_count(); ++v) {
    tube.texcoords[v].t = 0.5F * tube.positions[v].y + 0.5F;
    tube.positions[v].y *= 20.0F;
  }
  Mesh flat_tube = tube;
  for (glm::vec3& p : flat_tube.positions) p.y *= 0.01F;
  Mesh wide = quad(1.0F);  // texels stay square on long models
  for (glm::vec3& p : wide.positions) p = p * glm::vec3(3.0F, 1.0F, 1.0F) + glm::vec3(100.0F, 0.0F, -7.0F);
  for (glm::vec2& st : wide.texcoords) st.t = st.t / 3.0F + 1.0F / 3.0F;
  const std::pair<Mesh, Projection> rows[] = {{sphere(12, 24), Projection::spherical},
                                              {tube, Projection::cylindrical},
                                              {flat_tube, Projection::cylindrical},
                                              {cube_split(2.0F), Projection::box},
                                              {wide, Projection::box},
                                              {wide, Projection::planar}};
  for (const auto& [exact, projection] : rows) {
    const Mesh mesh = laid_out(test::bare(exact), projection);
    // Seams are split as the primitive has them; of a cube some faces have the same at a corner.
    EXPECT_EQ(mesh.vertex_count(), exact.vertex_count() == 24 ? 20 : exact.vertex_count());
    ASSERT_EQ(mesh.indices.size(), exact.indices.size());
    for (std::size_t i = 0; i < mesh.indices.size(); ++i)  // float32 of 1/2 - 1/6
      EXPECT_LT(glm::distance(mesh.texcoords[mesh.indices[i]], exact.texcoords[exact.indices[i]]), 1e-6F);
  }
}

TEST(Texcoords, no_triangle_runs_back_across_the_texture) {
  for (const Projection projection : {Projection::cylindrical, Projection::spherical})
    for (const Mesh& shape : {sphere(12, 24), torus(1.0F, 0.3F, 24, 12), icosphere(3)}) {
      const Mesh mesh = laid_out(test::bare(shape), projection);
      for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto s = [&](std::size_t k) { return mesh.texcoords[mesh.indices[i + k]].s; };
        const auto [least, greatest] = std::minmax({s(0), s(1), s(2)});
        EXPECT_LE(greatest - least, 0.5F);
      }
    }
}

TEST(Texcoords, are_finite_for_any_mesh) {
  Mesh flat;
  flat.positions = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {2, 1, 1}, {3, 1, 1}};
  flat.indices = {0, 1, 2, 0, 3, 4};
  for (const Projection projection :
       {Projection::planar, Projection::box, Projection::cylindrical, Projection::spherical})
    for (const Mesh& shape : {flat, icosphere(1, 1e37F), icosphere(1, 1e-30F), Mesh{}}) {
      const Mesh mesh = laid_out(shape, projection);
      EXPECT_EQ(mesh.texcoords.size(), mesh.vertex_count());
      for (const glm::vec2& st : mesh.texcoords) EXPECT_TRUE(std::isfinite(st.s) && std::isfinite(st.t));
    }
}

TEST(TextureLayout, leans_squeezes_and_turns_s_round) {
  Mesh mesh = quad();
  mesh.tangents.assign(4, {1, 0, 0, 1});
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
