// SPDX-License-Identifier: MIT
#include "image/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "image/colour.hpp"

namespace texel::image {
namespace {

/// One pixel's difference.
struct PixelDifference {
  enum class State { compared, non_finite, left_out } state = State::compared;
  double largest = 0;
  double sum = 0;  ///< over its samples
};

using Pixels = std::vector<PixelDifference>;

template <class Sample>
void check_sizes(const Image<Sample>& reference, const Image<Sample>& image, const Image8* mask) {
  const auto same = [&](const auto& other) {
    return other.width == reference.width && other.height == reference.height;
  };
  if (!same(image))
    throw Error::failed(fmt::format("the pictures differ in size: {}x{} and {}x{}", reference.width,
                                    reference.height, image.width, image.height),
                        {}, "draw both in the same size");
  if (mask && !same(*mask))
    throw Error::failed(fmt::format("the mask is {}x{}, the pictures {}x{}", mask->width, mask->height,
                                    reference.width, reference.height),
                        {}, "give a mask of the pictures' size");
}

/// `pixel(x, y)` for every pixel that the mask lets through.
template <class Sample, class Pixel>
Pixels difference_of(const Image<Sample>& reference, const Image<Sample>& image, const Image8* mask,
                     Pixel pixel) {
  check_sizes(reference, image, mask);
  Pixels pixels;
  pixels.reserve(static_cast<std::size_t>(reference.width) * static_cast<std::size_t>(reference.height));
  bool any = false;
  for (int y = 0; y < reference.height; ++y)
    for (int x = 0; x < reference.width; ++x) {
      const bool counts = !mask || mask->at(x, y) > 0;
      any |= counts;
      pixels.push_back(counts ? pixel(x, y) : PixelDifference{PixelDifference::State::left_out});
    }
  if (!any)
    throw Error::failed("there is no pixel to compare", {},
                        "give pictures with pixels and a mask with light ones");
  return pixels;
}

Pixels difference_of(const Image8& reference, const Image8& image, const Image8* mask) {
  const auto rgb = [](const Image8& picture, int x, int y, int c) {
    return static_cast<int>(picture.at(x, y, picture.channels < 3 ? 0 : c));
  };
  return difference_of(reference, image, mask, [&](int x, int y) {
    PixelDifference pixel;
    for (int c = 0; c < 3; ++c) {
      const double difference = std::abs(rgb(reference, x, y, c) - rgb(image, x, y, c));
      pixel.largest = std::max(pixel.largest, difference);
      pixel.sum += difference;
    }
    return pixel;
  });
}

/// The angle between two vectors in degrees; 180 where only one is zero.
PixelDifference angle(const float* a, const float* b) {
  const auto zero = [](const float* v) { return v[0] == 0 && v[1] == 0 && v[2] == 0; };
  if (zero(a) && zero(b)) return {PixelDifference::State::left_out};
  if (zero(a) || zero(b)) return {PixelDifference::State::compared, 180, 180};
  const std::array<double, 3> u = {a[0], a[1], a[2]};
  const std::array<double, 3> v = {b[0], b[1], b[2]};
  const double cross =
      std::hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  const double dot = u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
  const double degrees = std::atan2(cross, dot) * 180 / std::numbers::pi;
  return {PixelDifference::State::compared, degrees, degrees};
}

Pixels difference_of(const ImageF& reference, const ImageF& image, Unit unit, const Image8* mask) {
  if (reference.channels != image.channels || (unit == Unit::degrees && image.channels < 3))
    throw Error::failed(fmt::format("pictures of {} and {} channels cannot be compared{}", reference.channels,
                                    image.channels, unit == Unit::degrees ? " as directions" : ""),
                        {}, "draw the same view twice");
  return difference_of(reference, image, mask, [&](int x, int y) {
    const float* a = &reference.at(x, y);
    const float* b = &image.at(x, y);
    const int channels = unit == Unit::degrees ? 3 : reference.channels;
    const auto finite = [](float v) { return std::isfinite(v); };
    if (!std::all_of(a, a + channels, finite) || !std::all_of(b, b + channels, finite))
      return PixelDifference{PixelDifference::State::non_finite};
    if (unit == Unit::degrees) return angle(a, b);
    PixelDifference pixel;
    for (int c = 0; c < channels; ++c) {
      const double difference = std::abs(static_cast<double>(a[c]) - static_cast<double>(b[c]));
      pixel.largest = std::max(pixel.largest, difference);
      pixel.sum += difference;
    }
    return pixel;
  });
}

Difference figures(int width, int height, int samples_per_pixel, const Pixels& pixels) {
  Difference result{width, height};
  std::vector<double> largest;
  double sum = 0;
  for (const PixelDifference& pixel : pixels) {
    if (pixel.state == PixelDifference::State::non_finite) ++result.non_finite;
    if (pixel.state != PixelDifference::State::compared) continue;
    largest.push_back(pixel.largest);
    sum += pixel.sum;
  }
  if (largest.empty()) return result;
  const std::size_t rank = (99 * largest.size() + 99) / 100;  // ceil(0.99 n), counted from 1
  std::nth_element(largest.begin(), largest.begin() + static_cast<std::ptrdiff_t>(rank - 1), largest.end());
  result.p99 = largest[rank - 1];
  result.max = *std::max_element(largest.begin(), largest.end());
  result.mean = sum / static_cast<double>(largest.size()) / samples_per_pixel;
  return result;
}

Image8 picture(int width, int height, double full_scale, const Pixels& pixels) {
  if (full_scale <= 0)
    for (const PixelDifference& pixel : pixels) full_scale = std::max(full_scale, pixel.largest);
  Image8 result(width, height, 3);
  std::uint8_t* out = result.samples.data();
  for (const PixelDifference& pixel : pixels) {
    double t = full_scale > 0 ? pixel.largest / full_scale : 0;
    if (pixel.state == PixelDifference::State::non_finite) t = std::numeric_limits<double>::quiet_NaN();
    for (const float value : heat(static_cast<float>(t))) *out++ = to_encoding8(value, Encoding::linear);
  }
  return result;
}

}  // namespace

Difference compare(const Image8& reference, const Image8& image, const Image8* mask) {
  return figures(image.width, image.height, 3, difference_of(reference, image, mask));
}

Difference compare(const ImageF& reference, const ImageF& image, Unit unit, const Image8* mask) {
  return figures(image.width, image.height, unit == Unit::degrees ? 1 : image.channels,
                 difference_of(reference, image, unit, mask));
}

Image8 heatmap(const Image8& reference, const Image8& image, double full_scale, const Image8* mask) {
  return picture(image.width, image.height, full_scale, difference_of(reference, image, mask));
}

Image8 heatmap(const ImageF& reference, const ImageF& image, Unit unit, double full_scale,
               const Image8* mask) {
  return picture(image.width, image.height, full_scale, difference_of(reference, image, unit, mask));
}

}  // namespace texel::image
