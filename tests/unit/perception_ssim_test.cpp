// SPDX-License-Identifier: MIT
// SSIM against what is known by hand.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "../support/flip_pictures.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "perception/perception.hpp"

namespace texel::perception {
namespace {

using namespace image;
using test::error_of;

constexpr double kC1 = 6.5025, kC2 = 58.5225;  // (0.01 * 255)^2 and (0.03 * 255)^2

Image8 flat(int value, int width = 20, int height = 15) {
  return made(width, height, [=](int, int) { return value; });
}

Image8 waves(int width, int height) {
  return made(width, height,
              [](int x, int y) { return 128 + 60 * std::sin(0.7 * x) + 50 * std::cos(0.4 * y + 0.1 * x); });
}

/// The paper's formula, pixel by pixel with its square window, the border repeated.
double straightforward(const Image8& a, const Image8& b) {
  double sum = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      double weights = 0, mean_a = 0, mean_b = 0;
      const auto window = [&](const std::function<void(double weight, double a, double b)>& act) {
        for (int v = -5; v <= 5; ++v)
          for (int u = -5; u <= 5; ++u) {
            const int s = std::clamp(x + u, 0, a.width - 1), t = std::clamp(y + v, 0, a.height - 1);
            act(std::exp(-(u * u + v * v) / 4.5), a.at(s, t), b.at(s, t));
          }
      };
      window([&](double weight, double value_a, double value_b) {
        weights += weight;
        mean_a += weight * value_a;
        mean_b += weight * value_b;
      });
      mean_a /= weights;
      mean_b /= weights;
      double variance_a = 0, variance_b = 0, covariance = 0;
      window([&](double weight, double value_a, double value_b) {
        variance_a += weight / weights * (value_a - mean_a) * (value_a - mean_a);
        variance_b += weight / weights * (value_b - mean_b) * (value_b - mean_b);
        covariance += weight / weights * (value_a - mean_a) * (value_b - mean_b);
      });
      sum += (2 * mean_a * mean_b + kC1) * (2 * covariance + kC2) /
             ((mean_a * mean_a + mean_b * mean_b + kC1) * (variance_a + variance_b + kC2));
    }
  return sum / (a.width * a.height);
}

TEST(Ssim, is_one_for_the_same_and_compares_means_alone_for_constant_pictures) {
  EXPECT_EQ(ssim(waves(40, 30), waves(40, 30)), 1);
  EXPECT_EQ(ssim(flat(0), flat(0)), 1);
  // Variances and covariance are 0, and (0 + C2) / (0 + C2) is 1.
  for (const auto& [a, b] : {std::pair{100, 110}, {0, 255}, {0, 1}, {254, 255}, {128, 64}})
    EXPECT_NEAR(ssim(flat(a), flat(b)), (2.0 * a * b + kC1) / (a * a + b * b + kC1), 1e-12)
        << a;  // sums of doubles; the variance of 255 is 0 to 1e-11
}

TEST(Ssim, agrees_with_the_straightforward_version) {
  const Image8 a = waves(33, 27);
  const Image8 noisy = made(33, 27, [&](int x, int y) { return a.at(x, y) / 2 + (x * 37 + y * 91) % 90; });
  Image8 dot = a;
  dot.at(20, 3) = 255;
  const Image8 moved = made(33, 27, [&](int x, int y) { return a.at(std::max(0, x - 1), y); });
  for (const Image8& b : {noisy, dot, moved, flipped(a)}) {
    // Means of squares of up to 255^2, less the mean's square: 1e-11 of 58.
    EXPECT_NEAR(ssim(a, b), straightforward(a, b), 1e-11);
    EXPECT_EQ(ssim(a, b), ssim(b, a));
    EXPECT_LT(ssim(a, b), 1);
  }
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 7}, {4, 3}})
    EXPECT_NEAR(ssim(waves(width, height), flat(90, width, height)),
                straightforward(waves(width, height), flat(90, width, height)), 1e-11);
}

TEST(Ssim, takes_the_luma_of_encoded_values) {
  Image8 color(20, 15, 4);
  for (std::size_t i = 0; i < color.samples.size(); ++i)
    color.samples[i] = std::array<std::uint8_t, 4>{200, 100, 50, static_cast<std::uint8_t>(i)}[i % 4];
  const double luma = 0.299 * 200 + 0.587 * 100 + 0.114 * 50;  // 124.2; alpha counts for nothing
  EXPECT_NEAR(ssim(color, flat(60)), (2 * luma * 60 + kC1) / (luma * luma + 3600 + kC1), 1e-12);
}

TEST(Ssim, looks_only_where_the_mask_is_light) {
  const Image8 a = flat(100, 40, 40), b = made(40, 40, [](int x, int) { return x < 20 ? 100 : 150; });
  const auto columns = [](int from, int to) {
    return made(40, 40, [=](int x, int) { return x >= from && x < to ? 255 : 0; });
  };
  const Image8 left = columns(0, 15), right = columns(25, 40), dark = columns(0, 0), small = flat(1);
  EXPECT_EQ(ssim(a, b, &left), 1);  // windows reach 5 pixels
  EXPECT_NEAR(ssim(a, b, &right), (2.0 * 100 * 150 + kC1) / (10000 + 22500 + kC1), 1e-12);
  EXPECT_NE(error_of([&] { ssim(a, b, &dark); }), "");
  EXPECT_NE(error_of([&] { ssim(a, b, &small); }), "");
  EXPECT_NE(error_of([&] { ssim(a, small); }), "");
  EXPECT_NE(error_of([&] { ssim(Image8(), Image8()); }), "");
}

}  // namespace
}  // namespace texel::perception
