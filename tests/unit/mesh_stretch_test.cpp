// SPDX-License-Identifier: MIT
#include "mesh/stretch.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../support/meshes.hpp"
#include "core/error.hpp"
#include "cube.hpp"
#include "mesh/primitives.hpp"
#include "mesh/weld.hpp"
#include "steps.hpp"

namespace texel::mesh {
namespace {

using namespace cube_wrap;

using test::icosphere;

/// The square of half-size 1 whose texture coordinates are (x, y) times the matrix with these columns.
Mesh textured_square(const glm::mat2& texture) {
  Mesh mesh = quad(1.0F);
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i)
    mesh.texcoords[i] = texture * glm::vec2(mesh.positions[i]);
  return mesh;
}

/// Squares of half-size 1 and 3, each with the whole texture.
Mesh two_squares() {
  Mesh mesh = quad(1.0F);
  const Mesh big = quad(3.0F);
  for (std::size_t i = 0; i < 4; ++i) {
    mesh.positions.push_back(big.positions[i] + glm::vec3(10, 0, 0));
    mesh.normals.push_back(big.normals[i]);
    mesh.texcoords.push_back(big.texcoords[i]);
  }
  for (const std::uint32_t index : big.indices) mesh.indices.push_back(index + 4);
  return mesh;
}

Mesh smeared_square(bool in_space_too) {
  Mesh mesh = quad(1.0F);
  mesh.texcoords.assign(4, {0.5F, 0.5F});
  if (in_space_too) mesh.positions.assign(4, {1, 2, 3});
  return mesh;
}

TEST(Stretch, is_what_sander_s_formulas_give_by_hand) {
  struct Row {
    const char* name;
    Mesh mesh;
    double l2, l_infinity, mean_shear, max_shear;
    std::uint32_t smeared, mirrored;
  };
  const double phi = (1 + std::sqrt(5.0)) / 2, even = std::sqrt(20.0);
  const Row rows[] = {
      {"even", textured_square({{1, 0}, {0, 1}}), 1, 1, 0, 0, 0, 0},
      {"fine", textured_square({{64, 0}, {0, 64}}), 1, 1, 0, 0, 0, 0},
      {"coarse", textured_square({{0.125F, 0}, {0, 0.125F}}), 1, 1, 0, 0, 0, 0},
      // One step in s reaches 4, one in t 1; spread evenly both would reach 2.
      {"4 to 1", textured_square({{0.25F, 0}, {0, 1}}), std::sqrt((16 + 1) / 2.0) / 2, 2, 0, 0, 0, 0},
      // s = x + y, t = y: a step in t at equal s goes along (-1, 1). Singular values of a shear by 1.
      {"sheared", textured_square({{1, 0}, {1, 1}}), std::sqrt((1 + 2) / 2.0), phi, 45, 45, 0, 0},
      // Of the report's cube the four sides are smeared and the back is mirrored; what is left is even.
      {"cube before", cube_shared(cube_before), 1, 1, 0, 0, 8, 2},
      // Mirrored are the back, and one triangle of each other side; 8 of 12 triangles are sheared.
      {"cube stretched", cube_shared(cube_stretched), std::sqrt((4 * 1 + 8 * 1.5) / 12), phi, 30, 45, 0, 6},
      {"cube by face", weld(cube_by_face()), 1, 1, 0, 0, 0, 0},
      // Triangles weigh by their area in space: steps of 2 and 6, spread evenly sqrt((4 + 36) / 2).
      {"two squares", two_squares(), std::sqrt((4.0 * 4 + 36.0 * 36) / 40) / even, 6 / even, 0, 0, 0, 0},
      {"no area in the texture", smeared_square(false), 0, 0, 0, 0, 2, 0},
      {"none in space either: not on the surface at all", smeared_square(true), 0, 0, 0, 0, 0, 0},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    std::vector<std::string> lines = describe_stretch(row.mesh);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0], fmt::format("{} of {} triangles are smeared (no texture area), {} mirrored",
                                    row.smeared, row.mesh.triangle_count(), row.mirrored));
    EXPECT_EQ(lines[1], fmt::format("stretch of the others: {:.3f} on average (L2), {:.3f} at most (L "
                                    "infinity); 1 is even",
                                    row.l2, row.l_infinity));
    EXPECT_EQ(lines[2],
              fmt::format("shear: {:.1f} degrees on average, {:.1f} at most", row.mean_shear, row.max_shear));
  }
  EXPECT_THROW(describe_stretch(icosphere(0)), Error) << "no texture coordinates";
}

TEST(Stretch, has_the_deviation_of_normals_that_a_cube_s_eight_vertices_share) {
  // The arc cosine of 1 / sqrt(3).
  EXPECT_EQ(describe_stretch(cube_shared(cube_before))[3],
            "normals: 54.7 degrees from their triangle's on average, 54.7 at most");
  EXPECT_EQ(describe_stretch(weld(cube_by_face()))[3],
            "normals: 0.0 degrees from their triangle's on average, 0.0 at most");
  Mesh mesh = quad();
  mesh.normals.clear();
  EXPECT_THROW(describe_stretch(mesh), Error);
}

}  // namespace
}  // namespace texel::mesh
