// SPDX-License-Identifier: MIT
#include "truth/cube_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "../support/oracles.hpp"
#include "procedural/cube_maps.hpp"

namespace texel::truth {
namespace {

using glm::dvec2;
using glm::dvec3;
using image::face_coordinate;
using test::number;

dvec3 vector(int i) {
  return 2.0 * dvec3(number(i, 0), number(i, 1), number(i, 2)) - 1.0;
}

bool is_edge(const dvec2& st) {
  return st.s == 0 || st.s == 1 || st.t == 0 || st.t == 1;
}

TEST(TruthCubeMap, direction_and_coordinate_go_back_and_forth_on_every_face) {
  std::vector<dvec2> places;
  for (int i = 0; i < 500; ++i) places.emplace_back(number(i, 0), number(i, 1));
  for (double x = 0; x <= 1;
       x += 0.125)  // edges and corners are one place seen from every face that has them
    places.insert(places.end(), {{x, 0}, {x, 1}, {0, x}, {1, x}});
  for (const image::Face face : procedural::faces)
    for (const dvec2& st : places) {
      const dvec3 direction = procedural::direction(face, st.s, st.t);
      EXPECT_NEAR(glm::length(direction), 1, 4e-16);
      const auto back = face_coordinate(7.0 * direction);
      EXPECT_TRUE(back.face == face || is_edge(st));
      EXPECT_LT(test::angle(procedural::direction(back.face, back.s, back.t), direction), 4e-16);
    }
}

TEST(TruthCubeMap, face_gradient_is_what_differences_show) {
  int compared = 0;
  for (int i = 0; i < 1000; ++i) {
    const dvec3 direction = vector(i);
    const DirectionGradient change{vector(i + 5000), vector(i + 9000)};
    const double length = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
    const TexcoordGradient gradient = face_gradient(direction, change);
    for (const auto& [step, expected] :
         {std::pair{change.dx, gradient.dx}, std::pair{change.dy, gradient.dy}}) {
      const auto at = [&](double distance) { return face_coordinate(direction + distance * step); };
      if (at(1e-6).face != at(-1e-6).face || length < 0.3) continue;
      // Rounding 1e-16 / 1e-6, and the step squared over the cube of a length of 0.3.
      EXPECT_LT(
          glm::distance(
              expected,
              test::difference(1e-6, [&](double distance) { return dvec2(at(distance).s, at(distance).t); })),
          2e-9);
      ++compared;
    }
  }
  EXPECT_GT(compared, 1600);
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
  const std::pair<dvec3, dvec2> rows[] = {{{0, 0, 2}, {0, 0.5}},
                                          {{2, 0, 0}, {-0.25, 0.5}},
                                          {{-1, 0, 0}, {0.25, 0.5}},
                                          {{0, 0, -1}, {-0.5, 0.5}},
                                          {{-1e-300, 0, -1}, {0.5, 0.5}},  // the seam
                                          {{0, 1, 0}, {0, 0}},
                                          {{0, -1, 0}, {0, 1}}};
  for (const auto& [direction, texcoord] : rows) EXPECT_EQ(worksheet_texcoord(direction), texcoord);
  // They turn those of the sphere by half a turn.
  for (int i = 0; i < 500; ++i) {
    const dvec2 sum = worksheet_texcoord(vector(i)) + sphere_texcoord(vector(i));
    EXPECT_NEAR(sum.x, std::round(sum.x), 2e-16);
    EXPECT_NEAR(sum.y, 1, 4e-16);
  }
}

TEST(TruthCubeMap, worksheet_gradient_is_what_differences_show_across_the_seam_too) {
  int across_seam = 0;
  for (int i = 0; i < 2000; ++i) {
    dvec3 direction = vector(i);
    if (i % 2 == 0) direction = {1e-7 * direction.x, direction.y, -1};
    if (std::hypot(direction.x, direction.z) < 0.2) continue;
    const DirectionGradient change{vector(i + 5000), vector(i + 9000)};
    const TexcoordGradient gradient = worksheet_gradient(direction, change);
    for (const auto& [step, expected] :
         {std::pair{change.dx, gradient.dx}, std::pair{change.dy, gradient.dy}}) {
      dvec2 difference =
          worksheet_texcoord(direction + 1e-6 * step) - worksheet_texcoord(direction - 1e-6 * step);
      across_seam += std::abs(difference.x) > 0.5;
      difference.x -= std::round(difference.x);
      // Rounding 2e-16 / 1e-6, and the step squared over the cube of 0.2.
      EXPECT_LT(glm::distance(expected, difference / 2e-6), 2e-9);
    }
  }
  EXPECT_GT(across_seam, 500);
}

}  // namespace
}  // namespace texel::truth
