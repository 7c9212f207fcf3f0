// SPDX-License-Identifier: MIT
// FLIP against what is known by hand; image_flip_plain_test.cpp holds it to double precision.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "../support/flip_pictures.hpp"
#include "../support/plain_flip.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "image/flip.hpp"

namespace texel::image {
namespace {

using test::error_of;

/// FLIP of two constant colours (linear RGB): the filters leave constants, and there are no features.
double flip_of_colors(const Vector& a, const Vector& b) {
  return plain_color_error(plain_hyab(plain_hunt_lab(a), plain_hunt_lab(b)));
}

// ---- Colour and constants ----

TEST(FlipConstants, follow_from_the_primaries_and_the_white_of_srgb) {
  // IEC 61966-2-1: the primaries' chromaticities; D65 to five digits, as the published matrix takes it.
  const auto xyz = [](double x, double y) { return Vector{x / y, 1, (1 - x - y) / y}; };
  const std::array<Vector, 3> primaries = {xyz(0.64, 0.33), xyz(0.30, 0.60), xyz(0.15, 0.06)};
  const Vector white = xyz(0.31271, 0.32902);
  const Vector luminances = solve(primaries, white);
  for (std::size_t c = 0; c < 3; ++c) {
    Vector one{};
    one[c] = 1;
    // The published rationals are rounded to 8 digits.
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(plain_xyz(one)[i], luminances[c] * primaries[c][i], 1e-7);
    EXPECT_NEAR(white[c], white_xyz[c], 1e-7);
  }
}

TEST(FlipConstants, see_the_pictures_at_67_pixels_a_degree) {
  // In the middle of the display a pixel of 0.7 m / 3840 is seen from 0.7 m.
  EXPECT_NEAR(default_pixels_per_degree, 67.02, 0.005);
}

TEST(Flip, is_the_redistributed_distance_for_constant_colors) {
  const std::array<std::array<std::uint8_t, 3>, 9> colors = {{{0, 0, 0},
                                                              {255, 255, 255},
                                                              {0, 255, 0},
                                                              {0, 0, 255},
                                                              {255, 0, 0},
                                                              {128, 128, 128},
                                                              {129, 128, 128},
                                                              {10, 200, 240},
                                                              {250, 240, 5}}};
  const auto linear_of = [](const std::array<std::uint8_t, 3>& rgb) {
    return Vector{plain_linear(rgb[0] / 255.0), plain_linear(rgb[1] / 255.0), plain_linear(rgb[2] / 255.0)};
  };
  for (const auto& a : colors)
    for (const auto& b : colors) {
      const ImageF errors = flip_errors(constant(40, 30, a), constant(40, 30, b));
      const double expected = flip_of_colors(linear_of(a), linear_of(b));
      // Floats: lightness to 1e-5 of 100, and the compressed distance is steepest near 0.
      for (const float error : errors.samples) ASSERT_NEAR(error, expected, 2e-5);
    }
}

TEST(Flip, is_known_for_black_and_white_and_for_green_and_blue) {
  // Black and white: L* 0 and 100, HyAB 100. Green and blue are the largest distance, so that FLIP is 1.
  const double black_white =
      flip_figures(flip_errors(constant(8, 8, {0, 0, 0}), constant(8, 8, {255, 255, 255}))).mean;
  const double largest = plain_hyab(plain_hunt_lab({0, 1, 0}), plain_hunt_lab({0, 0, 1}));
  EXPECT_NEAR(largest, 203.30, 0.005);
  const double part = std::pow(100 / largest, 0.7);  // 0.609, above p_c
  EXPECT_NEAR(black_white, 0.95 + 0.05 * (part - 0.4) / 0.6, 1e-6);
  EXPECT_NEAR(flip_figures(flip_errors(constant(8, 8, {0, 255, 0}), constant(8, 8, {0, 0, 255}))).mean, 1,
              1e-6);
}

// ---- Whole pictures ----

TEST(Flip, is_zero_when_the_pictures_are_the_same) {
  const ImageF errors = flip_errors(scene(64, 48), scene(64, 48));
  EXPECT_EQ(errors, ImageF(64, 48, 1));
}

TEST(Flip, is_the_same_when_the_pictures_change_places) {
  const Image8 a = scene(80, 50), b = scene(80, 50, 1);
  EXPECT_EQ(flip_errors(a, b), flip_errors(b, a));
}

TEST(Flip, is_mirrored_when_both_pictures_are) {
  const Image8 a = scene(80, 50), b = scene(80, 50, 1);
  const ImageF errors = flip_errors(a, b), mirror_errors = flip_errors(mirrored(a), mirrored(b));
  for (int y = 0; y < 50; ++y)
    for (int x = 0; x < 80; ++x) ASSERT_EQ(errors.at(x, y), mirror_errors.at(79 - x, y));
  EXPECT_EQ(flip_errors(flipped(a), flipped(b)), flipped(errors));
}

TEST(Flip, stays_within_0_and_1) {
  const Image8 a = scene(64, 64);
  for (const auto& b : {constant(64, 64, {0, 255, 0}), constant(64, 64, {255, 0, 255}),
                        changed(a, [](int v, std::size_t) { return v < 128 ? 255 : 0; })})
    for (const float error : flip_errors(a, b).samples) {
      ASSERT_GT(error, 0);
      ASSERT_LE(error, 1);
    }
  // Opposite checkers and the largest distance of colours at once.
  Image8 green = constant(32, 32, {0, 255, 0}), blue = constant(32, 32, {0, 0, 255});
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      if ((x / 4 + y / 4) % 2 == 0)
        for (int c = 0; c < 3; ++c) std::swap(green.at(x, y, c), blue.at(x, y, c));
  for (const float error : flip_errors(green, blue).samples) ASSERT_LE(error, 1);
}

TEST(Flip, is_the_same_in_the_whole_picture_and_near_what_differs) {
  // One dot: the errors are computed around it only, and must be those of a picture that differs everywhere
  // else by nothing that reaches it. A second dot in the far corner makes the box the whole picture.
  const Image8 a = scene(160, 120);
  Image8 near = a, far = a;
  for (Image8* b : {&near, &far}) b->at(40, 50, 1) = static_cast<std::uint8_t>(255 - a.at(40, 50, 1));
  for (const auto& [x, y] : {std::pair{159, 119}, {0, 119}, {159, 0}})
    far.at(x, y, 0) = static_cast<std::uint8_t>(far.at(x, y, 0) ^ 64);
  const ImageF near_errors = flip_errors(a, near), far_errors = flip_errors(a, far);
  for (int y = 30; y <= 70; ++y)
    for (int x = 20; x <= 60; ++x) ASSERT_EQ(near_errors.at(x, y), far_errors.at(x, y));
  EXPECT_GT(near_errors.at(40, 50), 0.01);
  // Colour filters reach 10 pixels; what lies farther away sees nothing.
  EXPECT_EQ(near_errors.at(51, 50), 0);
  EXPECT_EQ(near_errors.at(40, 61), 0);
}

TEST(Flip, grows_with_the_difference) {
  const Image8 a = scene(64, 48);
  double before = 0;
  for (const int steps : {1, 2, 5, 10, 20, 40}) {
    const Image8 b = changed(a, [&](int v, std::size_t) { return v + (v < 128 ? steps : -steps); });
    const double mean = flip_figures(flip_errors(a, b)).mean;
    EXPECT_GT(mean, before) << steps;
    before = mean;
  }
}

TEST(Flip, marks_the_edge_where_it_moved) {
  const ImageF errors = flip_errors(step(60, 40, 30), step(60, 40, 31));
  for (int x = 0; x < 60; ++x) {
    // Largest near column 30, which changed from white to black, and more so on the dark side of the edge.
    ASSERT_LE(errors.at(x, 20), errors.at(29, 20)) << x;
    ASSERT_EQ(errors.at(x, 20), errors.at(x, 3)) << "the picture does not change along y";
  }
  // Beyond the filters' 10 pixels nothing.
  EXPECT_EQ(errors.at(19, 20), 0);
  EXPECT_EQ(errors.at(41, 20), 0);
  EXPECT_LT(flip_figures(errors).mean, flip_figures(flip_errors(step(60, 40, 30), step(60, 40, 32))).mean);
}

TEST(Flip, forgives_fine_detail_from_farther_away) {
  // At 20 pixels a degree a pattern of dots is coarser for the eye than at 200, where it is a grey surface.
  const Image8 grey = constant(64, 64, {188, 188, 188});  // 187.5 is half the light of 255
  const Image8 dots = changed(grey, [](int, std::size_t i) { return (i / 3 + i / 192) % 2 == 0 ? 255 : 0; });
  const auto mean = [&](double ppd) { return flip_figures(flip_errors(grey, dots, ppd)).mean; };
  EXPECT_LT(mean(200), 0.2 * mean(20));
}

TEST(Flip, takes_grey_as_rgb_and_leaves_alpha_out) {
  Image8 grey(20, 20, 1), rgba(20, 20, 4), grey_alpha(20, 20, 2);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x) {
      const auto value = static_cast<std::uint8_t>(10 * x + y);
      grey.at(x, y) = grey_alpha.at(x, y) = value;
      grey_alpha.at(x, y, 1) = static_cast<std::uint8_t>(x);
      for (int c = 0; c < 3; ++c) rgba.at(x, y, c) = value;
      rgba.at(x, y, 3) = static_cast<std::uint8_t>(y);
    }
  EXPECT_EQ(flip_errors(grey, rgba), ImageF(20, 20, 1));
  EXPECT_EQ(flip_errors(grey, grey_alpha), ImageF(20, 20, 1));
}

TEST(Flip, is_an_error_when_it_cannot_be_seen) {
  const Image8 picture = scene(4, 4);
  for (const double ppd : {0.0, 0.9, -67.0, 1001.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(flip_errors(picture, picture, ppd), Error) << ppd;
}

TEST(Flip, is_an_error_when_the_sizes_differ) {
  EXPECT_NE(error_of([] { flip_errors(Image8(2, 3, 3), Image8(3, 2, 3)); }).find("2x3 and 3x2"),
            std::string::npos);
  EXPECT_NE(error_of([] { flip_errors(Image8(), Image8()); }), "");
}

// ---- Pooling ----

ImageF map_of(std::vector<float> values) {
  ImageF map(static_cast<int>(values.size()), 1, 1);
  map.samples = std::move(values);
  return map;
}

TEST(FlipFigures, are_pooled_by_hand) {
  // In order 0 0 0 0 0.1 0.2 0.3 0.4, sums 0.1 0.3 0.6 1: a quarter of 1 is reached at 0.2, half at 0.3,
  // three quarters at 0.4.
  const FlipFigures figures = flip_figures(map_of({0, 0.4F, 0, 0.1F, 0.3F, 0, 0.2F, 0}));
  EXPECT_NEAR(figures.mean, 0.125, 1e-8);  // floats of 24 bits
  EXPECT_EQ(figures.first_quartile, 0.2F);
  EXPECT_EQ(figures.median, 0.3F);
  EXPECT_EQ(figures.third_quartile, 0.4F);
  EXPECT_EQ(figures.p99, 0.4F);
}

TEST(FlipFigures, are_pooled_in_double_precision) {
  // A sum in floats would be off by 1e-3 of it.
  const ImageF map = map_of(std::vector<float>(std::size_t{1} << 20U, 0.1F));
  EXPECT_NEAR(flip_figures(map).mean, static_cast<double>(0.1F), 1e-9);
}

TEST(FlipFigures, are_zero_without_error) {
  const FlipFigures figures = flip_figures(map_of({0, 0, 0}));
  EXPECT_EQ(figures.mean, 0);
  EXPECT_EQ(figures.median, 0);
  EXPECT_EQ(figures.p99, 0);
}

TEST(FlipFigures, look_only_where_the_mask_is_light) {
  const ImageF map = map_of({0.5F, 0.25F, 1, 0.75F});
  Image8 mask(4, 1, 1);
  mask.samples = {255, 1, 0, 0};
  EXPECT_EQ(flip_figures(map, &mask).mean, 0.375);
  EXPECT_EQ(flip_figures(map, &mask).p99, 0.5);
  const Image8 dark(4, 1, 1), small(2, 1, 1);
  EXPECT_NE(error_of([&] { flip_figures(map, &dark); }), "");
  EXPECT_NE(error_of([&] { flip_figures(map, &small); }), "");
}

TEST(FlipHeatmap, has_the_colors_of_magma) {
  // 0, 64, 128, 192 and 255 of the map's 256 colours, and 200, which lies between two of ours.
  const Image8 heat = flip_heatmap(map_of({0, 64 / 255.0F, 128 / 255.0F, 192 / 255.0F, 1, 200 / 255.0F}));
  const std::vector<std::uint8_t> expected = {0,   0,   4,  81,  18,  124, 183, 55,  121,
                                              252, 137, 97, 252, 253, 191, 253, 152, 105};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(heat.samples[i], expected[i], 1) << i;
  Image8 mask(6, 1, 1);
  mask.at(1, 0) = 255;
  EXPECT_EQ(flip_heatmap(map_of(std::vector<float>(6, 1)), &mask).at(0, 0, 0), 0);
  EXPECT_EQ(flip_heatmap(map_of(std::vector<float>(6, 1)), &mask).at(1, 0, 0), 252);
}

}  // namespace
}  // namespace texel::image
