// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "procedural/cube_maps.hpp"
#include "procedural/height_fields.hpp"
#include "procedural/noise.hpp"
#include "procedural/shapes.hpp"
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

TEST(Textures, repeat_on_the_unit_square_and_stay_within_zero_and_one) {
  for (const Texture texture : textures)
    for (int i = 0; i < 2000; ++i) {
      const glm::dvec2 p = point(i);
      const glm::dvec4 here = color(texture, p.x, p.y), there = color(texture, p.x + 1, p.y - 1);
      ASSERT_EQ(glm::clamp(here, 0.0, 1.0), here) << name(texture);
      ASSERT_LT(glm::length(here - there), 1e-9) << name(texture);
    }
}

TEST(Textures, checker_is_black_and_white_and_starts_black) {
  for (int i = 0; i < 64; ++i) {
    const double expected = (i % 8 + i / 8) % 2;
    EXPECT_EQ(color(Texture::checker, (i % 8 + 0.01) / 8, (i / 8 + 0.99) / 8),
              glm::dvec4(expected, expected, expected, 1));
  }
}

TEST(Textures, label_grid_has_another_color_in_each_corner) {
  const auto corner = [](double u, double v) { return color(Texture::label_grid, u, v); };
  const glm::dvec4 red = corner(0.01, 0.01), green = corner(0.99, 0.01), blue = corner(0.01, 0.99),
                   yellow = corner(0.99, 0.99);
  EXPECT_GT(red.r, 5 * std::max(red.g, red.b));
  EXPECT_GT(green.g, 5 * std::max(green.r, green.b));
  EXPECT_GT(blue.b, 5 * std::max(blue.r, blue.g));
  EXPECT_GT(std::min(yellow.r, yellow.g), 5 * yellow.b);
}

TEST(Textures, decal_is_opaque_within_and_clear_without) {
  EXPECT_EQ(color(Texture::decal, 0.5, 0.5).a, 1);
  EXPECT_EQ(color(Texture::decal, 0.01, 0.01).a, 0);
}

TEST(Cube, direction_follows_the_table_of_the_specification) {
  // OpenGL 3.3 core, table 3.17: for (rx, ry, rz) on each face, sc and tc. On a tie x goes before y before z.
  struct Row {
    glm::dvec3 r;
    Face face;
    double sc, tc;
  };
  const Row rows[] = {{{1, 0.25, 0.5}, Face::positive_x, -0.5, -0.25},
                      {{-1, 0.25, 0.5}, Face::negative_x, 0.5, -0.25},
                      {{0.25, 1, 0.5}, Face::positive_y, 0.25, 0.5},
                      {{0.25, -1, 0.5}, Face::negative_y, 0.25, -0.5},
                      {{0.25, 0.5, 1}, Face::positive_z, 0.25, -0.5},
                      {{0.25, 0.5, -1}, Face::negative_z, -0.25, -0.5},
                      {{1, 1, 1}, Face::positive_x, -1, -1},
                      {{-1, 1, -1}, Face::negative_x, -1, -1},
                      {{0, -1, 1}, Face::negative_y, 0, -1}};
  for (const Row& row : rows) {
    const FaceCoordinate at = face_coordinate(row.r);
    EXPECT_EQ(at.face, row.face);
    EXPECT_DOUBLE_EQ(at.s, 0.5 * (row.sc + 1));
    EXPECT_DOUBLE_EQ(at.t, 0.5 * (row.tc + 1));
    EXPECT_NEAR(glm::distance(direction(at.face, at.s, at.t), glm::normalize(row.r)), 0, 1e-15);
  }
}

TEST(Cube, smooth_color_stays_within_zero_and_one) {
  double low = 1, high = 0;
  for (const Face face : faces)
    for (int i = 0; i < 61 * 61; ++i) {
      const glm::dvec3 c = smooth_color(direction(face, i % 61 / 60.0, i / 61 / 60.0));
      low = std::min({low, c.r, c.g, c.b});
      high = std::max({high, c.r, c.g, c.b});
    }
  EXPECT_GE(low, 0);
  EXPECT_LE(high, 1);
  EXPECT_GT(high - low, 0.9);  // and uses nearly all of it
}

TEST(Cube, labels_read_the_right_way_round_from_inside) {
  // Looking along -z with y up, x runs right: the minus of "-Z" is on the left, its strokes symmetric about a
  // middle line that nothing crosses above it.
  const auto is_white = [](glm::dvec3 d) {
    const glm::dvec3 c = labelled_color(d);
    return std::min({c.r, c.g, c.b}) > 0.9;
  };
  const double minus_height = 0.12 + 3 * 0.095;
  EXPECT_TRUE(is_white({-0.3, minus_height, -1}));  // the minus
  EXPECT_FALSE(is_white({-0.3, minus_height + 0.2, -1}));
  EXPECT_TRUE(is_white({0.4, 0.12 + 6 * 0.095, -1}));  // the upper stroke of the Z
  // Looking along +x with y up, z runs right: the plus is towards -z.
  EXPECT_TRUE(is_white({1, minus_height, -0.3}));
  // The head tilted back from -z: what was up before lies towards +z.
  EXPECT_TRUE(is_white({-0.3, 1, minus_height}));
  EXPECT_TRUE(is_white({-0.3, -1, -minus_height}));
}

TEST(Shapes, text_has_strokes_where_its_letters_have_and_a_star_has_a_point_upwards) {
  struct Row {
    const char* text;
    double x, y, half_stroke;
    bool is_in;
  };
  for (const auto& [text, x, y, half_stroke, is_in] :
       std::vector<Row>{{"L", 0, 3, 1e-9, true},   // the stem
                        {"L", 2, 0, 1e-9, true},   // the foot
                        {"L", 4, 6, 3.99, false},  // nothing upper right
                        {"L", 4, 6, 4.01, true},
                        {"L", -0.74, 3, 0.75, true},
                        {"L", -0.76, 3, 0.75, false},
                        {"L", 2, -0.74, 0.75, true},
                        {"L", 4.74, 0, 0.75, true},
                        {"T", 2, 6.74, 0.75, true},
                        {"T", 2, 6.76, 0.75, false},
                        {"AL", 6, 3, 1e-9, true},  // the next letter stands 6 further right
                        {" ", 2, 3, 100, false}})
    EXPECT_EQ(in_text(text, x, y, half_stroke), is_in) << text << ' ' << x << ' ' << y;
  EXPECT_TRUE(in_star(0, 0.99, 5, 1, 0.4));
  EXPECT_FALSE(in_star(0, -0.5, 5, 1, 0.4));
  EXPECT_TRUE(in_star(0, -0.39, 5, 1, 0.4));
}

TEST(Noise, is_the_same_on_every_machine) {
  EXPECT_EQ(hash(1, 2, 3), 298021697u);  // as computed once: only 32-bit integer arithmetic goes in
}

}  // namespace
}  // namespace texel::procedural
