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
    for (int i = 0; i < n; ++i) sum += picture({x + (i + 0.5) / n, y + (j + 0.5) / n});
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

TEST(RepeatedTexture, has_the_mean_over_areas_of_any_shape_and_place) {
  // Stripes of the width 1/8 across s, one in eight white: the mean over a parallelogram by hand, exact.
  const RepeatedTexture stripes([](dvec2 st) { return dvec4(st.s - std::floor(st.s) < 0.125 ? 1 : 0); });
  const auto covered = [](double s) {  // of the numbers from 0 to s
    return std::floor(s) * 0.125 + std::min(s - std::floor(s), 0.125);
  };
  for (const double s : {-3.71, 0.0, 0.06, 1e6 + 0.33}) {
    const double width = 2.3;
    const auto mean = stripes.mean({dvec2(s, 5.4), {s + width, 5.4}, {s + width, 6.1}, {s, 6.1}});
    ASSERT_TRUE(mean);
    EXPECT_NEAR(mean->r, (covered(s + width) - covered(s)) / width, 1e-9) << s;
  }
  // Against a million samples of a picture, over quadrilaterals of any shape.
  const auto brick = [](dvec2 st) { return procedural::color(procedural::Texture::brick, st.s, st.t); };
  const RepeatedTexture repeated(brick);
  constexpr std::array<dvec2, 4> shapes[] = {{{{0.2, 0.1}, {1.7, 0.4}, {1.9, 1.3}, {0.3, 0.9}}},
                                             {{{0.5, -4}, {0.9, 0.2}, {0.4, 3}, {0.1, 0.3}}},
                                             {{{7, 7}, {7, 7.3}, {6.6, 7.3}, {6.6, 7}}}};
  for (const auto& c : shapes) {
    dvec4 sum(0);
    double area = 0;
    constexpr int n = 300;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const double u = (i + 0.5) / n, v = (j + 0.5) / n;
        const dvec2 du = glm::mix(c[1] - c[0], c[2] - c[3], v), dv = glm::mix(c[3] - c[0], c[2] - c[1], u);
        const double part = std::abs(du.x * dv.y - du.y * dv.x);
        sum += part * brick(glm::mix(glm::mix(c[0], c[1], u), glm::mix(c[3], c[2], u), v));
        area += part;
      }
    const auto mean = repeated.mean(c);
    ASSERT_TRUE(mean);
    // Measured 1.4e-4: the sums have 512 x 512 cells.
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR((*mean)[channel], (sum / area)[channel], 5e-4);
  }
  EXPECT_FALSE(repeated.mean({dvec2(0, 0), {0.1, 0}, {0.1, 0.1}, {0, 0.1}})) << "a few samples are as good";
}

TEST(RepeatedTexture, may_repeat_after_more_than_one) {
  const RepeatedTexture halves([](dvec2 st) { return dvec4(std::fmod(st.s, 2) < 1 ? 1 : 0); }, 2);
  const auto mean = halves.mean({dvec2(0.5, 0), {3, 0}, {3, 1}, {0.5, 1}});
  ASSERT_TRUE(mean);
  EXPECT_NEAR(mean->g, 1.5 / 2.5, 1e-12);
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
