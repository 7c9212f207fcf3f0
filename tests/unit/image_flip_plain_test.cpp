// SPDX-License-Identifier: MIT
// FLIP against the same in double precision (support/plain_flip.hpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "../support/flip_pictures.hpp"
#include "../support/plain_flip.hpp"
#include "image/flip.hpp"

namespace texel::image {
namespace {

/// The largest difference of the fast errors from those in double precision.
double distance_to_plain(const Image8& a, const Image8& b, double ppd = default_pixels_per_degree,
                         PlainFilters filters = PlainFilters::square) {
  const ImageF fast = flip_errors(a, b, ppd);
  const std::vector<double> slow = plain_flip(a, b, filters, ppd);
  double largest = 0;
  for (std::size_t i = 0; i < slow.size(); ++i)
    largest = std::max(largest, std::abs(slow[i] - static_cast<double>(fast.samples[i])));
  return largest;
}

TEST(FlipPlain, agrees_with_double_precision) {
  const Image8 reference = scene(72, 60);
  const std::vector<Image8> others = {
      scene(72, 60, 1),
      mirrored(reference),
      flipped(reference),
      constant(72, 60, {0, 0, 0}),
      changed(reference, [](int v, std::size_t i) { return v + (i % 3 == 0 ? 1 : 0); }),
      changed(reference, [](int v, std::size_t) { return v + 5; }),
      changed(reference, [](int v, std::size_t i) { return i == 9000 ? 255 - v : v; }),
      changed(reference, [](int, std::size_t i) { return noise(static_cast<unsigned>(i)); })};
  // Measured: up to 1e-5, 6e-5 for the dot. There the colours are nearly the same, the features are not, and
  // the roots make much of the rounding of floats.
  for (std::size_t i = 0; i < others.size(); ++i) {
    EXPECT_LT(distance_to_plain(reference, others[i]), 1e-4) << i;
  }
  // Measured: 9.4e-5, where white beside the edge is nearly white in both.
  EXPECT_LT(distance_to_plain(step(50, 40, 20), step(50, 40, 21)), 1e-4);
}

TEST(FlipPlain, agrees_at_other_distances_and_in_small_pictures) {
  for (const double ppd : {1.0, 12.0, 30.0, 110.0})
    EXPECT_LT(distance_to_plain(scene(33, 21), scene(33, 21, 2), ppd), 1e-4) << ppd;
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {5, 2}, {17, 16}})
    EXPECT_LT(distance_to_plain(scene(width, height), scene(width, height, 1)), 1e-4) << width;
}

TEST(FlipPlain, is_the_same_by_squares_and_by_rows_and_columns) {
  const Image8 a = scene(72, 60), b = scene(72, 60, 1);
  for (const double ppd : {12.0, default_pixels_per_degree}) {
    const std::vector<double> square = plain_flip(a, b, PlainFilters::square, ppd),
                              separable = plain_flip(a, b, PlainFilters::separable, ppd);
    // Measured: 2e-13, the order in which doubles are added up.
    for (std::size_t i = 0; i < square.size(); ++i) ASSERT_NEAR(square[i], separable[i], 1e-11);
  }
}

TEST(FlipPlain, agrees_in_a_large_picture) {
  const Image8 reference = scene(400, 300);
  EXPECT_LT(
      distance_to_plain(reference, scene(400, 300, 1), default_pixels_per_degree, PlainFilters::separable),
      1e-4);
}

}  // namespace
}  // namespace texel::image
