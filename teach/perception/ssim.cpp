// SPDX-License-Identifier: MIT
#include "perception/perception.hpp"

#include "filter.hpp"
#include "image/comparison.hpp"

namespace texel::perception {
namespace {

using image::Image8;

using Plane = Image<double>;  // of one channel

constexpr int radius = 5;
constexpr double sigma = 1.5;
constexpr double c1 = (0.01 * 255) * (0.01 * 255), c2 = (0.03 * 255) * (0.03 * 255);

Plane luma(const Image8& picture) {
  Plane result(picture.width, picture.height, 1);
  for (int y = 0; y < result.height; ++y)
    for (int x = 0; x < result.width; ++x) {
      const auto rgb = [&](int c) { return static_cast<double>(rgb_sample(picture, x, y, c)); };
      result.at(x, y) = 0.299 * rgb(0) + 0.587 * rgb(1) + 0.114 * rgb(2);
    }
  return result;
}

/// The similarity at each pixel.
Plane similarity(const Plane& a, const Plane& b) {
  const Kernel<double> kernel = even_kernel<double>(gaussian(sigma, radius));
  const auto mean = [&](const Plane& values) { return filtered(values, kernel, kernel); };
  const auto mean_of_product = [&](Plane product, const Plane& other) {
    for (std::size_t i = 0; i < product.samples.size(); ++i) product.samples[i] *= other.samples[i];
    return mean(product);
  };
  const Plane mean_a = mean(a), mean_b = mean(b);
  const Plane mean_aa = mean_of_product(a, a), mean_bb = mean_of_product(b, b),
              mean_ab = mean_of_product(a, b);
  Plane result(a.width, a.height, 1);
  for (std::size_t i = 0; i < result.samples.size(); ++i) {
    const double ma = mean_a.samples[i], mb = mean_b.samples[i];
    const double variance_a = mean_aa.samples[i] - ma * ma, variance_b = mean_bb.samples[i] - mb * mb;
    const double covariance = mean_ab.samples[i] - ma * mb;
    result.samples[i] = (2 * ma * mb + c1) * (2 * covariance + c2) /
                        ((ma * ma + mb * mb + c1) * (variance_a + variance_b + c2));
  }
  return result;
}

}  // namespace

double ssim(const Image8& reference, const Image8& image, const Image8* mask) {
  check_sizes(reference, image, mask);
  const Plane similar = similarity(luma(reference), luma(image));
  double sum = 0;
  long long pixels = 0;
  for (int y = 0; y < reference.height; ++y)
    for (int x = 0; x < reference.width; ++x) {
      if (!counts(mask, x, y)) continue;
      ++pixels;
      sum += similar.at(x, y);
    }
  image::check_any(pixels > 0);
  return sum / static_cast<double>(pixels);
}

}  // namespace texel::perception
