// SPDX-License-Identifier: MIT
// Separable filters for the metrics. Beyond the border a picture goes on as its border pixels.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "image/image.hpp"

namespace texel::perception {

using image::Image;

/// How a kernel's two sides belong together.
enum class Symmetry {
  even,     ///< the same weights on both sides
  odd,      ///< negative ones on the lower side; the middle weighs 0
  zero_sum  ///< even, and the middle weighs minus the sum of all others
};

/// Weights along one axis: of the pixel itself at [0], of the two pixels k away at [k]. Kernels that add up
/// to zero do not use [0]: they weigh differences, so that even surfaces give 0 and no rounding errors.
template <class Real>
struct Kernel {
  std::vector<Real> weights;
  Symmetry symmetry = Symmetry::even;

  [[nodiscard]] int radius() const { return static_cast<int>(weights.size()) - 1; }
};

/// exp(-k^2 / (2 sigma^2)) for k = 0 to `radius`.
inline std::vector<double> gaussian(double sigma, int radius) {
  std::vector<double> values;
  for (int k = 0; k <= radius; ++k) values.push_back(std::exp(-k * k / (2 * sigma * sigma)));
  return values;
}

/// The sum of all weights of a symmetric kernel, those on the other side too.
inline double sum_of(const std::vector<double>& weights) {
  double sum = weights[0];
  for (std::size_t k = 1; k < weights.size(); ++k) sum += 2 * weights[k];
  return sum;
}

/// An even kernel whose weights add up to `sum`, without outer ones that are nothing beside the middle: below
/// 1e-12, far less than rounding, since FLIP's power functions make much of what falls into black.
template <class Real>
Kernel<Real> even_kernel(std::vector<double> weights, double sum = 1) {
  const double scale = sum / sum_of(weights);
  while (weights.back() < 1e-12 * weights.front()) weights.pop_back();
  Kernel<Real> kernel;
  for (const double weight : weights) kernel.weights.push_back(static_cast<Real>(scale * weight));
  return kernel;
}

/// out[x] += the kernel over the rows that `row_at(k)` gives for k = -radius to radius, for x < width. Blocks
/// of fixed size let the compiler keep the sums in vector registers.
template <class Real, class RowAt>
void add_filtered(const Kernel<Real>& kernel, int width, const RowAt& row_at, Real* out) {
  constexpr int block = 32;
  const auto filter_block = [&](int x, int count) {
    Real sums[block] = {};
    const Real* here = row_at(0) + x;
    const auto add = [&](int k) {
      const Real weight = kernel.weights[static_cast<std::size_t>(k)];
      const Real* before = row_at(-k) + x;
      const Real* after = row_at(k) + x;
      switch (kernel.symmetry) {
        case Symmetry::even:
          for (int i = 0; i < count; ++i) sums[i] += weight * (before[i] + after[i]);
          break;
        case Symmetry::odd:
          for (int i = 0; i < count; ++i) sums[i] += weight * (after[i] - before[i]);
          break;
        case Symmetry::zero_sum:
          for (int i = 0; i < count; ++i) sums[i] += weight * ((before[i] - here[i]) + (after[i] - here[i]));
          break;
      }
    };
    for (int k = kernel.radius(); k > 0; --k) add(k);
    const Real middle = kernel.symmetry == Symmetry::even ? kernel.weights[0] : Real(0);
    for (int i = 0; i < count; ++i) out[x + i] += sums[i] + middle * here[i];
  };
  int x = 0;
  for (; x + block <= width; x += block) filter_block(x, block);
  filter_block(x, width - x);
}

/// The picture (one channel) filtered along its rows, then along its columns.
template <class Real>
Image<Real> filtered(const Image<Real>& picture, const Kernel<Real>& along_x, const Kernel<Real>& along_y) {
  Image<Real> rows(picture.width, picture.height, 1), result = rows;
  const int radius = along_x.radius();
  std::vector<Real> row(static_cast<std::size_t>(picture.width + 2 * radius));
  for (int y = 0; y < picture.height; ++y) {
    const Real* const in = &picture.at(0, y);
    const auto inner = row.begin() + radius;
    std::fill(row.begin(), inner, in[0]);
    std::copy_n(in, picture.width, inner);
    std::fill(inner + picture.width, row.end(), in[picture.width - 1]);
    add_filtered(
        along_x, picture.width, [&](int k) { return row.data() + radius + k; }, &rows.at(0, y));
  }
  for (int y = 0; y < picture.height; ++y) {
    const auto row_at = [&](int k) { return &rows.at(0, std::clamp(y + k, 0, picture.height - 1)); };
    add_filtered(along_y, picture.width, row_at, &result.at(0, y));
  }
  return result;
}

}  // namespace texel::perception
