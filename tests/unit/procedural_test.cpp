// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "procedural/cube_maps.hpp"
#include "procedural/height_fields.hpp"
#include "procedural/noise.hpp"
#include "procedural/textures.hpp"

namespace texel::procedural {
namespace {

using image::Face;
using image::face_coordinate;
using image::FaceCoordinate;

/// Points spread over the unit square, the same on every run.
glm::dvec2 point(int i) {
  return {random(i, 0, 1), random(i, 1, 1)};
}

class HeightFields : public testing::TestWithParam<HeightField> {};

INSTANTIATE_TEST_SUITE_P(, HeightFields,
                         testing::Values(HeightField::brick, HeightField::wood, HeightField::scales,
                                         HeightField::bump));

TEST_P(HeightFields, have_the_gradient_that_differences_show_and_unit_normals_that_lean_away_from_the_rise) {
  const auto difference = [](glm::dvec2 p, glm::dvec2 e) {
    return (height(GetParam(), p.x + e.x, p.y + e.y).value - height(GetParam(), p.x - e.x, p.y - e.y).value) /
           (2 * (e.x + e.y));
  };
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec2 p = point(i);
    const Dual h = height(GetParam(), p.x, p.y);
    // Measured: 4.7e-8 for wood, whose rings curve most; it falls with the square of the step down to 2e-8,
    // where the rounding of heights of 0.01 takes over.
    ASSERT_NEAR(h.du, difference(p, {1e-7, 0}), 2e-7);
    ASSERT_NEAR(h.dv, difference(p, {0, 1e-7}), 2e-7);
    const glm::dvec3 n = normal(GetParam(), p.x, p.y);
    ASSERT_NEAR(glm::length(n), 1, 1e-15);  // a few roundings of 1.1e-16
    ASSERT_NEAR(n.x / n.z, -h.du, 1e-12);   // slopes up to 3, a few roundings
    ASSERT_NEAR(n.y / n.z, -h.dv, 1e-12);
    ASSERT_EQ(normal(GetParam(), p.x, p.y, 0), glm::dvec3(0, 0, 1));
  }
}

TEST_P(HeightFields, go_on_smoothly_where_one_cell_meets_the_next) {
  // Bricks, planks and scales meet at multiples of 1/48 or, where they are displaced, in a flat groove.
  for (int i = 0; i < 48 * 400; ++i) {
    const double across = i / 400 / 48.0, along = random(i / 400, i % 400, 2), e = 1e-12;
    for (const bool is_u : {true, false}) {
      const auto at = [&](double u) {
        return is_u ? height(GetParam(), u, along) : height(GetParam(), along, u);
      };
      const Dual a = at(across - e), b = at(across + e);
      ASSERT_NEAR(a.value, b.value, 1e-11);  // slopes up to 3 over 2e-12
      ASSERT_NEAR(a.du, b.du, 1e-7);         // curvature up to 5000 over 2e-12
      ASSERT_NEAR(a.dv, b.dv, 1e-7);
    }
  }
}

TEST_P(HeightFields, repeat_on_the_unit_square) {
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec2 p = point(i);
    const Dual here = height(GetParam(), p.x, p.y);
    for (const glm::dvec2 shift : {glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(-1, -2)}) {
      const Dual there = height(GetParam(), p.x + shift.x, p.y + shift.y);
      ASSERT_NEAR(here.value, there.value, 1e-14);  // measured 3e-16: u + 1 rounds u
      ASSERT_NEAR(here.du, there.du, 1e-11);        // measured 1.2e-13, by the curvature of the rings
      ASSERT_NEAR(here.dv, there.dv, 1e-11);
    }
  }
}

// That they look as they should is held by the bundled pictures: assets.are_what_make_assets_makes.
TEST(Textures, repeat_on_the_unit_square_and_stay_within_zero_and_one) {
  for (const Texture texture : textures)
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec2 p = point(i);
      const glm::dvec4 here = color(texture, p.x, p.y), there = color(texture, p.x + 1, p.y - 1);
      ASSERT_EQ(glm::clamp(here, 0.0, 1.0), here) << name(texture);
      ASSERT_LT(glm::length(here - there), 1e-9) << name(texture);
    }
}

TEST(Cube, direction_follows_the_table_of_the_specification) {
  // OpenGL 3.3 core, table 3.17: for (rx, ry, rz) on each face, sc and tc. On a tie x goes before y before z.
  const std::tuple<glm::dvec3, Face, double, double> rows[] = {
      {{1, 0.25, 0.5}, Face::positive_x, -0.5, -0.25},
      {{-1, 0.25, 0.5}, Face::negative_x, 0.5, -0.25},
      {{0.25, 1, 0.5}, Face::positive_y, 0.25, 0.5},
      {{0.25, -1, 0.5}, Face::negative_y, 0.25, -0.5},
      {{0.25, 0.5, 1}, Face::positive_z, 0.25, -0.5},
      {{0.25, 0.5, -1}, Face::negative_z, -0.25, -0.5},
      {{1, 1, 1}, Face::positive_x, -1, -1},
      {{-1, 1, -1}, Face::negative_x, -1, -1},
      {{0, -1, 1}, Face::negative_y, 0, -1}};
  for (const auto& [r, face, sc, tc] : rows) {
    const FaceCoordinate at = face_coordinate(r);
    EXPECT_EQ(at.face, face);
    EXPECT_DOUBLE_EQ(at.s, 0.5 * (sc + 1));
    EXPECT_DOUBLE_EQ(at.t, 0.5 * (tc + 1));
    EXPECT_NEAR(glm::distance(direction(at.face, at.s, at.t), glm::normalize(r)), 0, 1e-15);
  }
}

}  // namespace
}  // namespace texel::procedural
