// SPDX-License-Identifier: MIT
#include "mesh/stretch.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/meshes.hpp"
#include "core/error.hpp"
#include "cube.hpp"
#include "mesh/normals.hpp"
#include "mesh/primitives.hpp"
#include "mesh/weld.hpp"

namespace texel::mesh {
namespace {

using test::icosphere;

// Figures of a few exact float coordinates, computed in double: what is left is the last digit of a root.
constexpr double rounding = 1e-12;

/// The square of half-size 1 whose texture coordinates are (x, y) times the matrix with these columns.
Mesh square(glm::vec2 by_x, glm::vec2 by_y) {
  Mesh mesh = quad(1.0f);
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i)
    mesh.texcoords[i] = mesh.positions[i].x * by_x + mesh.positions[i].y * by_y;
  return mesh;
}

TEST(Stretch, is_one_when_the_texture_lies_evenly_at_any_scale) {
  for (const float scale : {1.0f, 0.125f, 64.0f}) {
    const Stretch stretch = measure_stretch(square({scale, 0}, {0, scale}));
    EXPECT_NEAR(stretch.l2, 1, rounding) << scale;
    EXPECT_NEAR(stretch.l_infinity, 1, rounding) << scale;
    EXPECT_NEAR(stretch.max_shear, 0, rounding) << scale;
    EXPECT_EQ(stretch.zero_area_triangles, 0u);
    EXPECT_EQ(stretch.mirrored_triangles, 0u);
  }
}

TEST(Stretch, follows_sander_when_one_side_is_four_times_as_long) {
  // One step in s reaches 4, one in t 1; spread evenly both would reach 2.
  const Stretch stretch = measure_stretch(square({0.25f, 0}, {0, 1}));
  EXPECT_NEAR(stretch.l2, std::sqrt((16 + 1) / 2.0) / 2, rounding);
  EXPECT_NEAR(stretch.l_infinity, 2, rounding);
  EXPECT_NEAR(stretch.max_shear, 0, rounding);
}

TEST(Stretch, tells_the_shear_in_degrees) {
  // s = x + y, t = y: a step in t at equal s goes along (-1, 1).
  const Stretch stretch = measure_stretch(square({1, 0}, {1, 1}));
  EXPECT_NEAR(stretch.mean_shear, 45, rounding);
  EXPECT_NEAR(stretch.max_shear, 45, rounding);
  EXPECT_NEAR(stretch.l2, std::sqrt((1 + 2) / 2.0), rounding);
  EXPECT_NEAR(stretch.l_infinity, (1 + std::sqrt(5.0)) / 2, rounding);  // singular values of a shear by 1
}

TEST(Stretch, counts_smeared_and_mirrored_triangles_of_the_reports_cubes) {
  const Stretch before = measure_stretch(cube_shared(cube_before));
  EXPECT_EQ(before.zero_area_triangles, 8u);  // the four sides
  EXPECT_EQ(before.mirrored_triangles, 2u);   // the back
  EXPECT_NEAR(before.l2, 1, rounding);        // of what is left, front and back

  const Stretch stretched = measure_stretch(cube_shared(cube_stretched));
  EXPECT_EQ(stretched.zero_area_triangles, 0u);
  EXPECT_EQ(stretched.mirrored_triangles, 6u);  // the back, and one triangle of each of the other four
  EXPECT_NEAR(stretched.l2, std::sqrt((4 * 1 + 8 * 1.5) / 12),
              rounding);  // 8 of 12 triangles are sheared by 45 degrees
  EXPECT_NEAR(stretched.max_shear, 45, rounding);

  const Stretch split = measure_stretch(weld(cube_by_face()));
  EXPECT_EQ(split.zero_area_triangles + split.mirrored_triangles, 0u);
  EXPECT_NEAR(split.l_infinity, 1, rounding);
}

TEST(Stretch, weighs_triangles_by_their_area_in_space) {
  // The same texture area on squares of half-size 1 and 3: steps of 2 and 6; spread evenly sqrt((4 + 36) /
  // 2).
  Mesh mesh = quad(1.0f);
  const Mesh big = quad(3.0f);
  for (std::size_t i = 0; i < 4; ++i) {
    mesh.positions.push_back(big.positions[i] + glm::vec3(10, 0, 0));
    mesh.normals.push_back(big.normals[i]);
    mesh.texcoords.push_back(big.texcoords[i]);
  }
  for (const std::uint32_t index : big.indices) mesh.indices.push_back(index + 4);
  const double even = std::sqrt(20.0);
  const Stretch stretch = measure_stretch(mesh);
  EXPECT_NEAR(stretch.l2, std::sqrt((4.0 * 4 + 36.0 * 36) / 40) / even, rounding);
  EXPECT_NEAR(stretch.l_infinity, 6 / even, rounding);
}

TEST(Stretch, is_finite_without_any_area) {
  Mesh mesh = quad(1.0f);
  for (glm::vec2& st : mesh.texcoords) st = {0.5f, 0.5f};
  const Stretch smeared = measure_stretch(mesh);
  EXPECT_EQ(smeared.zero_area_triangles, 2u);
  EXPECT_EQ(smeared.l2, 0);
  for (glm::vec3& position : mesh.positions) position = {1, 2, 3};
  const Stretch point = measure_stretch(mesh);
  EXPECT_EQ(point.zero_area_triangles, 0u);  // of no area in space: not on the surface at all
  EXPECT_EQ(point.l_infinity, 0);
}

TEST(Stretch, is_an_error_without_texture_coordinates) {
  EXPECT_THROW(measure_stretch(icosphere(0)), Error);
}

TEST(NormalDeviation, is_that_of_the_cubes_corner_when_eight_vertices_share_normals) {
  const NormalDeviation shared = measure_normals(cube_shared(cube_before));
  const double corner = glm::degrees(std::acos(1 / std::sqrt(3.0)));
  // The stored normals are float32: 1e-7 rad are 6e-6 degrees.
  EXPECT_NEAR(shared.mean, corner, 1e-5);
  EXPECT_NEAR(shared.max, corner, 1e-5);
  EXPECT_EQ(measure_normals(weld(cube_by_face())).max, 0);
}

TEST(NormalDeviation, vanishes_for_flat_normals_and_shrinks_with_finer_spheres) {
  Mesh flat = icosphere(1);
  flat_normals(flat);
  EXPECT_LT(measure_normals(flat).max, 1e-5);  // float32 normals
  const double coarse = measure_normals(icosphere(1)).mean, fine = measure_normals(icosphere(2)).mean;
  EXPECT_GT(coarse, 1);
  EXPECT_NEAR(fine / coarse, 0.5, 0.03);  // measured 0.507: half the edge, half the angle, and curvature
}

TEST(Stretch, is_described_in_lines_with_the_figures) {
  const std::vector<std::string> lines = describe_stretch(cube_shared(cube_stretched));
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_EQ(lines[0], "0 of 12 triangles are smeared (no texture area), 6 mirrored");
  EXPECT_NE(lines[1].find("1.155 on average (L2), 1.618 at most"), std::string::npos) << lines[1];
  EXPECT_EQ(lines[2], "shear: 30.0 degrees on average, 45.0 at most");
  EXPECT_EQ(lines[3], "normals: 54.7 degrees from their triangle's on average, 54.7 at most");
}

TEST(NormalDeviation, is_an_error_without_normals) {
  Mesh mesh = quad();
  mesh.normals.clear();
  EXPECT_THROW(measure_normals(mesh), Error);
}

}  // namespace
}  // namespace texel::mesh
