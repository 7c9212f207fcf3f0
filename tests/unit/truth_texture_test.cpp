// SPDX-License-Identifier: MIT
#include "truth/texture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "procedural/textures.hpp"

namespace texel::truth {
namespace {

using glm::dvec2;
using glm::dvec4;

/// What is seen in pixel (x, y), row 0 at the bottom: the mean over n x n rays.
dvec4 pixel(const QuadPicture& picture, int x, int y, int n = 16) {
  dvec4 sum(0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) sum += picture.at({x + (i + 0.5) / n, y + (j + 0.5) / n});
  return sum / (static_cast<double>(n) * n);
}

TEST(TruthLevel, counts_how_often_the_longer_step_is_twice_a_texel) {
  EXPECT_EQ(level_of_detail({{1.0 / 64, 0}, {0, 1.0 / 64}}, {64, 64}), 0.0);
  EXPECT_EQ(level_of_detail({{1.0 / 64, 0}, {0, 4.0 / 64}}, {64, 64}), 2.0);
  EXPECT_EQ(level_of_detail({{1.0 / 64, 0}, {0, 1.0 / 64}}, {64, 256}), 2.0) << "texels, not widths";
  EXPECT_DOUBLE_EQ(level_of_detail({{3.0 / 64, 4.0 / 64}, {0, 0}}, {64, 64}), std::log2(5));
  EXPECT_EQ(level_of_detail({{0, 0}, {0, 0}}, {64, 64}), -std::numeric_limits<double>::infinity());
}

QuadPicture checker_picture() {
  // Half the window's height is 0.7 at distance 2, so the square fills the picture.
  const double opening = 2 * std::atan(0.35) * 180 / std::acos(-1.0);
  return {.camera = {.distance = 2, .field_of_view = opening, .width = 40, .height = 40},
          .world_from_object = {},
          .texcoord_map = {},
          .texture = [](dvec2 st) { return procedural::color(procedural::Texture::checker, st.s, st.t); }};
}

TEST(TruthQuadPicture, pixels_are_the_fields_of_the_checker_where_the_square_is_not_tilted) {
  const QuadPicture picture = checker_picture();
  for (int i = 0; i < 40 * 40; ++i) {
    const int x = i % 40, y = i / 40;
    // 5 pixels to a field of the checker, the first of which is black: each pixel lies within one.
    EXPECT_NEAR(pixel(picture, x, y, 4).r, (x / 5 + y / 5) % 2, 1e-12);
    EXPECT_EQ(pixel(picture, x, y, 4).a, 1.0);
  }
}

TEST(TruthQuadPicture, checker_of_whole_periods_a_pixel_is_grey) {
  QuadPicture picture = checker_picture();
  picture.texcoord_map = {.linear = glm::dmat2(10.0), .offset = {0.3 / 16, 0.7 / 16}};
  // A pixel covers 10 / 40 of a texture width: two fields each way, cut by 16 samples of 1/8 of a field.
  for (int i = 0; i < 40; ++i) EXPECT_EQ(pixel(picture, i, (7 * i) % 40).r, 0.5);
}

TEST(TruthQuadPicture, tilt_leans_the_top_away_and_alpha_is_the_coverage) {
  QuadPicture picture = checker_picture();
  picture.world_from_object = tilted(60);
  EXPECT_LT((picture.world_from_object.linear * glm::dvec3(0, 1, 0)).z, 0.0);
  EXPECT_EQ(pixel(picture, 20, 39).a, 0.0) << "above the square's top";
  EXPECT_EQ(pixel(picture, 20, 20).a, 1.0);
  double sum = 0;
  for (int i = 0; i < 40 * 40; ++i) sum += pixel(picture, i % 40, i / 40).a;
  // A trapezium from bottom to top, cut at the picture's sides: in the plane at distance 1, where the picture
  // reaches from -0.35 to 0.35, a corner at y = +-0.7 cos 60 and depth 2 +- 0.7 sin 60.
  const double far = 2 + 0.7 * std::sqrt(0.75), near = 2 - 0.7 * std::sqrt(0.75), pixel_size = 0.7 / 40;
  const double height = 0.35 / far + 0.35 / near;
  double area = 0;
  for (int i = 0; i < 1000; ++i)
    area += 2 * std::min(glm::mix(0.7 / near, 0.7 / far, (i + 0.5) / 1000), 0.35) * height / 1000;
  // Each edge lies within half a sample, 1/32 of a pixel, of where the samples see it: 31 + 40 pixels of top
  // and bottom, while the slanted sides average out. Measured: 1.4.
  EXPECT_NEAR(sum, area / (pixel_size * pixel_size), 71.0 / 32);
}

}  // namespace
}  // namespace texel::truth
