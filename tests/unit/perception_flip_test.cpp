// SPDX-License-Identifier: MIT
// FLIP against what is known by hand, and against the same in double precision (support/plain_flip.hpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "../support/flip_pictures.hpp"
#include "../support/plain_flip.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "perception/perception.hpp"

namespace texel::perception {
namespace {

using namespace image;
using test::error_of;

double mean_flip(const Image8& a, const Image8& b) {
  return flip_figures(flip_errors(a, b)).mean;
}

// ---- Colour and constants ----

TEST(FlipConstants, follow_from_the_primaries_and_the_white_of_srgb) {
  // IEC 61966-2-1: the primaries' chromaticities; D65 to five digits, as the published matrix takes it.
  const auto xyz = [](double x, double y) { return Vector{x / y, 1, (1 - x - y) / y}; };
  const glm::dmat3 primaries = {xyz(0.64, 0.33), xyz(0.30, 0.60), xyz(0.15, 0.06)};
  const Vector white = xyz(0.31271, 0.32902);
  const Vector luminances = glm::inverse(primaries) * white;
  for (int c = 0; c < 3; ++c) {
    Vector one{};
    one[c] = 1;
    // The published rationals are rounded to 8 digits.
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(plain_xyz(one)[i], luminances[c] * primaries[c][i], 1e-7);
    EXPECT_NEAR(white[c], white_xyz[c], 1e-7);
  }
  // In the middle of the display a pixel of 0.7 m / 3840 is seen from 0.7 m.
  EXPECT_NEAR(pixels_per_degree, 67.02, 0.005);
}

TEST(Flip, is_the_redistributed_distance_for_constant_colors) {
  // The filters leave constants, and there are no features.
  const std::vector<std::array<std::uint8_t, 3>> colors = {{0, 0, 0},       {255, 255, 255}, {0, 255, 0},
                                                           {0, 0, 255},     {255, 0, 0},     {128, 128, 128},
                                                           {129, 128, 128}, {10, 200, 240},  {250, 240, 5}};
  const auto lab_of = [](const std::array<std::uint8_t, 3>& rgb) {
    return plain_hunt_lab(
        {plain_linear(rgb[0] / 255.0), plain_linear(rgb[1] / 255.0), plain_linear(rgb[2] / 255.0)});
  };
  for (const auto& a : colors)
    for (const auto& b : colors) {
      const double expected = plain_color_error(plain_hyab(lab_of(a), lab_of(b)));
      // Floats: lightness to 1e-5 of 100, and the compressed distance is steepest near 0.
      for (const float error : flip_errors(constant(40, 30, a), constant(40, 30, b)).samples)
        ASSERT_NEAR(error, expected, 2e-5);
    }
  // Black and white: L* 0 and 100, HyAB 100. Green and blue are the largest distance, so that FLIP is 1.
  const double largest = plain_hyab(lab_of({0, 255, 0}), lab_of({0, 0, 255}));
  EXPECT_NEAR(largest, 203.30, 0.005);
  const double part = std::pow(100 / largest, 0.7);  // 0.609, above p_c
  EXPECT_NEAR(mean_flip(constant(8, 8, {0, 0, 0}), constant(8, 8, {255, 255, 255})),
              0.95 + 0.05 * (part - 0.4) / 0.6, 1e-6);
  EXPECT_NEAR(mean_flip(constant(8, 8, {0, 255, 0}), constant(8, 8, {0, 0, 255})), 1, 1e-6);
}

// ---- Whole pictures ----

TEST(Flip, takes_grey_as_rgb_and_leaves_alpha_out) {
  const Image8 grey = made(20, 20, [](int x, int y) { return 10 * x + y; });
  for (const int channels : {2, 4}) {
    Image8 with_alpha(20, 20, channels);
    for (std::size_t i = 0; i < grey.samples.size(); ++i)
      for (std::size_t c = 0, n = static_cast<std::size_t>(channels); c < n; ++c)
        with_alpha.samples[n * i + c] = c + 1 < n ? grey.samples[i] : static_cast<std::uint8_t>(i);
    EXPECT_EQ(flip_errors(grey, with_alpha), ImageF(20, 20, 1)) << channels;
  }
}

TEST(Flip, is_an_error_when_the_sizes_differ) {
  EXPECT_TRUE(test::has(error_of([] { flip_errors(Image8(2, 3, 3), Image8(3, 2, 3)); }), "2x3 and 3x2"));
  EXPECT_NE(error_of([] { flip_errors(Image8(), Image8()); }), "");
}

// ---- Double precision ----

TEST(FlipPlain, agrees_with_double_precision) {
  const Image8 reference = scene(72, 60);
  // The largest distance of colours and of features at once: also where it is cut off at 1.
  const auto checkers = [](std::size_t first) {
    return changed(Image8(32, 32, 3),
                   [=](int, std::size_t i) { return i % 3 == (i / 12 + i / 384 + first) % 2 + 1 ? 255 : 0; });
  };
  // Measured: up to 1e-5; 6e-5 for the dot, where the colours are nearly the same, the features are not, and
  // the roots make much of the rounding of floats; 9.4e-5 for the edge, where white beside it is nearly white
  // in both.
  const std::tuple<const char*, Image8, Image8> rows[] = {
      {"the same", reference, reference},
      {"moved", reference, scene(72, 60, 1)},
      {"mirrored", reference, mirrored(reference)},
      {"flipped", reference, flipped(reference)},
      {"black", reference, constant(72, 60, {0, 0, 0})},
      {"red", reference, changed(reference, [](int v, std::size_t i) { return v + (i % 3 == 0 ? 1 : 0); })},
      {"lighter", reference, changed(reference, [](int v, std::size_t) { return v + 5; })},
      {"a dot", reference, changed(reference, [](int v, std::size_t i) { return i == 9000 ? 255 - v : v; })},
      {"noise", reference,
       changed(reference, [](int, std::size_t i) { return noise(static_cast<unsigned>(i)); })},
      {"an edge", step(50, 40, 20), step(50, 40, 21)},
      {"checkers of green and blue", checkers(0), checkers(1)},
      {"1x1", scene(1, 1), scene(1, 1, 1)},
      {"1x9", scene(1, 9), scene(1, 9, 1)},
      {"5x2", scene(5, 2), scene(5, 2, 1)},
      {"17x16", scene(17, 16), scene(17, 16, 1)},
      {"large", scene(400, 300), scene(400, 300, 1)}};
  for (const auto& [what, a, b] : rows) {
    const ImageF fast = flip_errors(a, b);
    const std::vector<double> slow = plain_flip(a, b);
    double largest = 0;
    for (std::size_t i = 0; i < slow.size(); ++i) {
      largest = std::max(largest, std::abs(slow[i] - static_cast<double>(fast.samples[i])));
      ASSERT_TRUE(fast.samples[i] >= 0 && fast.samples[i] <= 1) << what;
    }
    EXPECT_LT(largest, 1e-4) << what;
  }
}

// ---- Pooling ----

ImageF map_of(std::vector<float> values) {
  ImageF map(static_cast<int>(values.size()), 1, 1);
  map.samples = std::move(values);
  return map;
}

TEST(FlipFigures, are_pooled_by_hand) {
  const FlipFigures figures = flip_figures(map_of({0, 0.4F, 0, 0.1F, 0.3F, 0, 0.2F, 0}));
  EXPECT_NEAR(figures.mean, 0.125, 1e-8);  // floats of 24 bits
  EXPECT_EQ(figures.p99, 0.4F);
  const FlipFigures none = flip_figures(map_of({0, 0, 0}));
  for (const double figure : {none.mean, none.p99}) EXPECT_EQ(figure, 0);
  // A sum in floats would be off by 1e-3 of it.
  const ImageF large = map_of(std::vector<float>(std::size_t{1} << 20U, 0.1F));
  EXPECT_NEAR(flip_figures(large).mean, static_cast<double>(0.1F), 1e-9);
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

}  // namespace
}  // namespace texel::perception
