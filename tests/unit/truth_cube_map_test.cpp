// SPDX-License-Identifier: MIT
#include "truth/cube_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <set>

#include "../support/numbers.hpp"
#include "../support/oracles.hpp"

namespace texel::truth {
namespace {

using glm::dvec2;
using glm::dvec3;
using procedural::face_coordinate;
using std::numbers::pi;
using test::angle;
using test::number;

dvec3 vector(int i) {
  return 2.0 * dvec3(number(i, 0), number(i, 1), number(i, 2)) - 1.0;
}

TEST(TruthCubeMap, direction_and_coordinate_go_back_and_forth_on_every_face) {
  for (const procedural::Face face : procedural::faces)
    for (int i = 0; i < 500; ++i) {
      const dvec2 st(number(i, 0), number(i, 1));
      const dvec3 direction = procedural::direction(face, st.s, st.t);
      EXPECT_NEAR(glm::length(direction), 1, 4e-16);
      const auto back = face_coordinate(7.0 * direction);
      EXPECT_EQ(back.face, face);
      EXPECT_NEAR(back.s, st.s, 4e-16);  // two roundings
      EXPECT_NEAR(back.t, st.t, 4e-16);
    }
}

TEST(TruthCubeMap, edges_and_corners_are_one_place_seen_from_every_face_that_has_them) {
  std::set<std::array<long, 3>> corners;
  for (const procedural::Face face : procedural::faces)
    for (int i = 0; i <= 8; ++i)
      for (const dvec2 st : {dvec2(i / 8.0, 0), dvec2(i / 8.0, 1), dvec2(0, i / 8.0), dvec2(1, i / 8.0)}) {
        const dvec3 direction = procedural::direction(face, st.s, st.t);
        const auto there = face_coordinate(direction);
        EXPECT_LT(angle(procedural::direction(there.face, there.s, there.t), direction), 4e-16);
        if (i == 0 || i == 8) {
          const dvec3 corner = glm::round(direction * 2.0);
          corners.insert({std::lround(corner.x), std::lround(corner.y), std::lround(corner.z)});
        }
      }
  EXPECT_EQ(corners.size(), 8u);
}

TEST(TruthCubeMap, face_gradient_is_what_differences_show) {
  constexpr double step = 1e-6;
  int compared = 0;
  for (int i = 0; i < 1000; ++i) {
    const dvec3 direction = vector(i);
    const DirectionGradient change{vector(i + 5000), vector(i + 9000)};
    const auto at = [&](dvec3 moved) { return face_coordinate(direction + moved); };
    const auto right = at(step * change.dx), left = at(-step * change.dx);
    const auto above = at(step * change.dy), below = at(-step * change.dy);
    const double length = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    if (right.face != left.face || above.face != below.face || length < 0.3) continue;
    const TexcoordGradient gradient = face_gradient(direction, change);
    // Rounding 1e-16 / 1e-6, and the step squared over the cube of a length of 0.3.
    EXPECT_LT(glm::distance(gradient.dx, dvec2(right.s - left.s, right.t - left.t) / (2 * step)), 2e-9);
    EXPECT_LT(glm::distance(gradient.dy, dvec2(above.s - below.s, above.t - below.t) / (2 * step)), 2e-9);
    ++compared;
  }
  EXPECT_GT(compared, 800);
}

TEST(TruthCubeMap, level_of_detail_is_zero_where_a_pixel_is_a_texel) {
  // In the middle of a face of 16 texels, a step of 2 / 16 of the distance to the face is one texel.
  const dvec3 middle(0, 0, -3);
  const DirectionGradient texel{{3 * 2.0 / 16, 0, 0}, {0, 3 * 2.0 / 16, 0}};
  EXPECT_NEAR(cube_level_of_detail(middle, texel, 16), 0, 1e-15);
  EXPECT_NEAR(cube_level_of_detail(middle, texel, 128), 3, 1e-15);
  EXPECT_NEAR(cube_level_of_detail(middle, {4.0 * texel.dx, texel.dy}, 16), 2, 1e-15)
      << "the longer step counts";
  EXPECT_EQ(cube_level_of_detail(middle, {dvec3(0), middle}, 16), -std::numeric_limits<double>::infinity())
      << "a step along the direction changes nothing";
}

TEST(TruthCubeMap, worksheet_coordinates_are_where_the_worksheet_says) {
  EXPECT_EQ(worksheet_texcoord({0, 0, 2}), dvec2(0, 0.5));
  EXPECT_EQ(worksheet_texcoord({2, 0, 0}), dvec2(-0.25, 0.5));
  EXPECT_EQ(worksheet_texcoord({-1, 0, 0}), dvec2(0.25, 0.5));
  EXPECT_EQ(worksheet_texcoord({0, 0, -1}).x, -0.5);
  EXPECT_EQ(worksheet_texcoord({-1e-300, 0, -1}).x, 0.5) << "the seam";
  EXPECT_EQ(worksheet_texcoord({0, 1, 0}), dvec2(0, 0));
  EXPECT_EQ(worksheet_texcoord({0, -1, 0}).y, 1.0);
}

TEST(TruthCubeMap, worksheet_coordinates_turn_those_of_the_sphere_by_half_a_turn) {
  for (int i = 0; i < 500; ++i) {
    const dvec2 a = worksheet_texcoord(vector(i)), b = sphere_texcoord(vector(i));
    const double turned = a.x + b.x;
    EXPECT_NEAR(turned, std::round(turned), 2e-16);
    EXPECT_NEAR(a.y + b.y, 1, 4e-16);
  }
}

TEST(TruthCubeMap, worksheet_gradient_is_what_differences_show_across_the_seam_too) {
  constexpr double step = 1e-6;
  int across_seam = 0;
  for (int i = 0; i < 2000; ++i) {
    dvec3 direction = vector(i);
    if (i % 2 == 0) direction = {1e-7 * direction.x, direction.y, -1};
    if (std::hypot(direction.x, direction.z) < 0.2) continue;
    const DirectionGradient change{vector(i + 5000), vector(i + 9000)};
    const TexcoordGradient gradient = worksheet_gradient(direction, change);
    for (const bool is_x : {true, false}) {
      const dvec3 moved = step * (is_x ? change.dx : change.dy);
      dvec2 difference = worksheet_texcoord(direction + moved) - worksheet_texcoord(direction - moved);
      if (std::abs(difference.x) > 0.5) {
        difference.x -= std::round(difference.x);
        ++across_seam;
      }
      // Rounding 2e-16 / 1e-6, and the step squared over the cube of 0.2.
      EXPECT_LT(glm::distance(is_x ? gradient.dx : gradient.dy, difference / (2 * step)), 2e-9);
    }
  }
  EXPECT_GT(across_seam, 500);
}

}  // namespace
}  // namespace texel::truth
