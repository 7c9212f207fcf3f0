// SPDX-License-Identifier: MIT
#include "truth/texture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "../support/numbers.hpp"

namespace texel::truth {
namespace {

using glm::dvec2;
using glm::dvec4;
using test::number;

/// Texel (x, y) holds x + 10 y.
Bitmap numbered(int width, int height) {
  return sampled([=](dvec2 st) { return dvec4(std::floor(st.s * width) + 10 * std::floor(st.t * height)); },
                 width, height);
}

TEST(TruthBitmap, holds_the_function_at_the_middle_of_each_texel) {
  const Bitmap bitmap = sampled([](dvec2 st) { return dvec4(st, 0, 1); }, 4, 2);
  EXPECT_EQ(bitmap.at(0, 0), dvec4(0.125, 0.25, 0, 1));
  EXPECT_EQ(bitmap.at(3, 1), dvec4(0.875, 0.75, 0, 1));
}

TEST(TruthBitmap, nearest_takes_the_texel_that_holds_the_coordinate) {
  const Bitmap bitmap = numbered(4, 3);
  EXPECT_EQ(nearest(bitmap, {0, 0}).r, 0.0);
  EXPECT_EQ(nearest(bitmap, {0.24, 0.34}).r, 10.0);
  EXPECT_EQ(nearest(bitmap, {0.25, 0.32}).r, 1.0) << "a border belongs to the larger index";
  EXPECT_EQ(nearest(bitmap, {0.99, 0.99}).r, 23.0);
}

TEST(TruthBitmap, wraps_as_opengl_does) {
  const Bitmap bitmap = numbered(4, 1);
  const auto at = [&](double s, Wrap wrap) { return nearest(bitmap, {s, 0.5}, wrap).r; };
  EXPECT_EQ(at(1.1, Wrap::repeat), 0.0);
  EXPECT_EQ(at(-0.1, Wrap::repeat), 3.0);
  EXPECT_EQ(at(1e7 + 0.3, Wrap::repeat), 1.0);
  EXPECT_EQ(at(1.1, Wrap::mirrored), 3.0);
  EXPECT_EQ(at(-0.1, Wrap::mirrored), 0.0);
  EXPECT_EQ(at(2.3, Wrap::mirrored), 1.0);
  EXPECT_EQ(at(-0.9, Wrap::mirrored), 3.0);
  EXPECT_EQ(at(7.0, Wrap::clamp), 3.0);
  EXPECT_EQ(at(-7.0, Wrap::clamp), 0.0);
}

TEST(TruthBitmap, bilinear_gives_the_texels_at_their_middles_and_any_linear_ramp_between) {
  const Bitmap bitmap = sampled([](dvec2 st) { return dvec4(st, 2 * st.s - st.t, 1); }, 8, 5);
  for (int i = 0; i < 500; ++i) {
    // At least half a texel from the border, where it would wrap.
    const dvec2 st(0.0625 + 0.875 * number(i, 0), 0.1 + 0.8 * number(i, 1));
    const dvec4 colour = bilinear(bitmap, st);
    EXPECT_NEAR(colour.r, st.s, 1e-15);
    EXPECT_NEAR(colour.g, st.t, 1e-15);
    EXPECT_NEAR(colour.b, 2 * st.s - st.t, 1e-15);
  }
  EXPECT_EQ(bilinear(bitmap, {0.3125, 0.5}), bitmap.at(2, 2));
  EXPECT_DOUBLE_EQ(bilinear(bitmap, {0, 0.5}).r, 0.5) << "the mean of the first and the last texel";
  EXPECT_EQ(bilinear(bitmap, {0, 0.5}, Wrap::clamp).r, 0.0625);
  EXPECT_EQ(bilinear(bitmap, {0, 0.5}, Wrap::mirrored).r, 0.0625);
}

TEST(TruthBitmap, one_texel_is_the_same_everywhere) {
  const Bitmap bitmap = sampled([](dvec2) { return dvec4(0.25); }, 1, 1);
  for (const Wrap wrap : {Wrap::repeat, Wrap::mirrored, Wrap::clamp})
    for (const double s : {-3.7, 0.0, 0.5, 1e6 + 0.1}) {
      EXPECT_EQ(nearest(bitmap, {s, s}, wrap), dvec4(0.25));
      EXPECT_EQ(bilinear(bitmap, {s, s}, wrap), dvec4(0.25));
    }
}

TEST(TruthLevel, counts_how_often_the_longer_step_is_twice_a_texel) {
  EXPECT_EQ(level_of_detail({{1.0 / 64, 0}, {0, 1.0 / 64}}, {64, 64}), 0.0);
  EXPECT_EQ(level_of_detail({{1.0 / 64, 0}, {0, 4.0 / 64}}, {64, 64}), 2.0);
  EXPECT_EQ(level_of_detail({{1.0 / 64, 0}, {0, 1.0 / 64}}, {64, 256}), 2.0) << "texels, not widths";
  EXPECT_DOUBLE_EQ(level_of_detail({{3.0 / 64, 4.0 / 64}, {0, 0}}, {64, 64}), std::log2(5));
  EXPECT_EQ(level_of_detail({{0, 0}, {0, 0}}, {64, 64}), -std::numeric_limits<double>::infinity());
}

TEST(TruthPixelMean, is_exact_for_a_ramp_and_falls_with_the_square_for_a_curve) {
  const auto ramp = [](dvec2 w) { return dvec4(w.x + 2 * w.y); };
  EXPECT_DOUBLE_EQ(pixel_mean(ramp, {3, 4}, 1).r, 3.5 + 9);
  EXPECT_DOUBLE_EQ(pixel_mean(ramp, {3, 4}, 16).r, 3.5 + 9);
  const auto error = [](int n) {
    return pixel_mean([](dvec2 w) { return dvec4(w.x * w.x); }, {0, 0}, n).r - 1.0 / 3;
  };
  EXPECT_NEAR(error(4) / error(8), 4, 1e-10);
}

TEST(TruthChecker, mean_is_one_half_over_whole_periods_and_exact_within_one_field) {
  EXPECT_EQ(checker_mean({0, 0}, {1, 1}), 0.5);
  EXPECT_NEAR(checker_mean({0.03, 0.4}, {0.28, 0.45}), 0.5, 1e-15) << "two fields wide, wherever they begin";
  EXPECT_EQ(checker_mean({0.01, 0.01}, {0.1, 0.1}), 0.0) << "the first field is black";
  EXPECT_EQ(checker_mean({0.13, 0.01}, {0.2, 0.1}), 1.0);
  EXPECT_EQ(checker_mean({-0.1, 0.01}, {-0.05, 0.1}), 1.0);
  EXPECT_NEAR(checker_mean({0.0625, 0.01}, {0.1875, 0.1}), 0.5, 1e-15) << "half and half";
  EXPECT_NEAR(checker_mean({0.0625, 0.0}, {0.15625, 0.125}), 1.0 / 3, 1e-15);
}

TEST(TruthChecker, mean_is_what_many_samples_of_the_texture_show) {
  const TextureFunction checker = texture_function(procedural::Texture::checker);
  constexpr int n = 256;
  for (int i = 0; i < 40; ++i) {
    const dvec2 low(number(i, 0) - 0.5, number(i, 1) - 0.5);
    const dvec2 size = 0.02 + 0.6 * dvec2(number(i, 2), number(i, 3));
    const double sampled_mean =
        pixel_mean([&](dvec2 window) { return checker(low + window * size); }, {0, 0}, n).r;
    // An edge across the rectangle is placed to half a sample, and up to 10 lie across: 10 / 2 / 256; they
    // cancel mostly. Measured: 2.2e-3.
    EXPECT_NEAR(checker_mean(low, low + size), sampled_mean, 6e-3);
  }
}

QuadPicture checker_picture() {
  // Half the window's height is 0.7 at distance 2, so the square fills the picture.
  const double opening = 2 * std::atan(0.35) * 180 / std::acos(-1.0);
  return {.camera = {.distance = 2, .field_of_view = opening, .width = 40, .height = 40},
          .world_from_object = {},
          .texcoord_map = {},
          .texture = texture_function(procedural::Texture::checker)};
}

TEST(TruthQuadPicture, pixels_are_the_exact_means_where_the_square_is_not_tilted) {
  const QuadPicture picture = checker_picture();
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      // 5 pixels to a field: each lies within one, so any number of samples is exact.
      const double exact = checker_mean(dvec2(x, y) / 40.0, dvec2(x + 1, y + 1) / 40.0);
      EXPECT_NEAR(picture.pixel(x, y, 4).r, exact, 1e-12);
      EXPECT_EQ(picture.pixel(x, y, 4).a, 1.0);
    }
}

TEST(TruthQuadPicture, checker_of_whole_periods_a_pixel_is_grey) {
  QuadPicture picture = checker_picture();
  picture.texcoord_map = {.linear = glm::dmat2(10.0), .offset = {0.3 / 16, 0.7 / 16}};
  // A pixel covers 10 / 40 of a texture width: two fields each way, cut by 16 samples of 1/8 of a field.
  for (int i = 0; i < 40; ++i) EXPECT_EQ(picture.pixel(i, (7 * i) % 40).r, 0.5);
}

TEST(TruthQuadPicture, error_against_the_exact_mean_falls_with_the_number_of_samples) {
  QuadPicture picture = checker_picture();
  const double scale = 3.7;
  picture.texcoord_map = {.linear = glm::dmat2(scale), .offset = {0.011, 0.007}};
  const auto rms = [&](int n) {
    double sum = 0;
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x) {
        const dvec2 low = picture.texcoord_map.texcoord(dvec2(x, y) / 40.0);
        const double exact = checker_mean(low, low + scale / 40.0);
        sum += std::pow(picture.pixel(x, y, n).r - exact, 2);
      }
    return std::sqrt(sum / 1600);
  };
  // One edge crosses most pixels: each sample column is right or wrong as a whole.
  EXPECT_GT(rms(1), 0.2);
  EXPECT_LT(rms(4), 0.3 * rms(1));
  EXPECT_LT(rms(16), 0.3 * rms(4));
  EXPECT_LT(rms(16), 0.03);
}

TEST(TruthQuadPicture, tilt_leans_the_top_away_and_alpha_is_the_coverage) {
  QuadPicture picture = checker_picture();
  picture.texture = [](dvec2 st) { return dvec4(st, 0, 1); };
  picture.world_from_object = tilted(60);
  EXPECT_LT((picture.world_from_object.linear * glm::dvec3(0, 1, 0)).z, 0.0);
  EXPECT_EQ(picture.pixel(20, 39).a, 0.0) << "above the square's top";
  EXPECT_EQ(picture.pixel(20, 20).a, 1.0);
  double sum = 0;
  bool partly = false;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 40; ++x) {
      const double coverage = picture.pixel(x, y).a;
      sum += coverage;
      partly = partly || (coverage > 0 && coverage < 1);
    }
  // A trapezium from bottom to top, cut at the picture's sides: in the plane at distance 1, where the picture
  // reaches from -0.35 to 0.35, a corner at y = +-0.7 cos 60 and depth 2 +- 0.7 sin 60.
  const double far = 2 + 0.7 * std::sqrt(0.75), near = 2 - 0.7 * std::sqrt(0.75), pixel = 0.7 / 40;
  const double height = 0.35 / far + 0.35 / near;
  double area = 0;
  for (int i = 0; i < 1000; ++i)
    area += 2 * std::min(glm::mix(0.7 / near, 0.7 / far, (i + 0.5) / 1000), 0.35) * height / 1000;
  // Each edge lies within half a sample, 1/32 of a pixel, of where the samples see it: 31 + 40 pixels of top
  // and bottom, while the slanted sides average out. Measured: 1.4.
  EXPECT_NEAR(sum, area / (pixel * pixel), 71.0 / 32);
  EXPECT_TRUE(partly);
}

}  // namespace
}  // namespace texel::truth
