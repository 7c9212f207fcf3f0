// SPDX-License-Identifier: MIT
#include "image/difference.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "image/color.hpp"
#include "image/comparison.hpp"

namespace texel::image {
namespace {

/// One pixel's difference.
struct PixelDifference {
  enum class State { compared, non_finite, left_out } state = State::compared;
  double largest = 0;
  double sum = 0;  ///< over its samples
  bool forgiven = false;
};

using State = PixelDifference::State;
using Pixels = std::vector<PixelDifference>;

/// An edge is where neighbours differ by more than this part of the whole range: more than shading does, less
/// than an object from what is behind it.
constexpr double edge_contrast = 1.0 / 8;
/// Smaller differences than this part of the whole range are no matter of a pixel more or less.
constexpr double least_forgiven = edge_contrast / 2;
/// The most of all edge pixels that may be forgiven. Measured on the labs' pictures: 0.06 or less between
/// Mesa's two rasterisers or after a turn by 0.02 degrees; 0.12 to 0.6 after a move by one pixel, but for 2
/// moves of 291, which changed next to nothing.
constexpr double most_forgiven = 0.1;

/// The angle between two vectors in degrees; 180 where only one is zero.
PixelDifference angle(const float* a, const float* b) {
  const glm::dvec3 u(a[0], a[1], a[2]), v(b[0], b[1], b[2]), zero(0), cross = glm::cross(u, v);
  if (!std::isfinite(glm::dot(u, u) + glm::dot(v, v))) return {State::non_finite};  // no square overflows
  if (u == zero && v == zero) return {State::left_out};
  if (u == zero || v == zero) return {State::compared, 180, 180};
  const double degrees =
      std::atan2(std::hypot(cross.x, cross.y, cross.z), glm::dot(u, v)) * 180 / std::numbers::pi;
  return {State::compared, degrees, degrees};
}

/// The difference of two pixels, whichever pictures they are of.
struct Apart {
  const Comparing& comparing;
  int channels;  ///< that are compared

  PixelDifference operator()(const float* a, const float* b) const {
    if (comparing.in_degrees) return angle(a, b);
    const auto difference = [&](int c) {
      return std::abs(static_cast<double>(a[c]) - static_cast<double>(b[c]));
    };
    PixelDifference pixel;
    for (int c = 0; c < channels; ++c) {
      pixel.largest = std::max(pixel.largest, difference(c));
      pixel.sum += difference(c);
    }
    // NaN and infinity in any channel reach the sum.
    return std::isfinite(pixel.sum) ? pixel : PixelDifference{State::non_finite};
  }
};

const float* pixel_of(const ImageF& picture, std::size_t i) {
  return &picture.samples[i * static_cast<std::size_t>(picture.channels)];
}

/// Calls `act` with the numbers of the i-th pixel and the up to 8 around it.
template <class Act>
void for_each_near(const ImageF& picture, std::size_t i, Act act) {
  const auto width = static_cast<std::size_t>(picture.width),
             height = static_cast<std::size_t>(picture.height);
  const std::size_t x = i % width, y = i / width;
  for (std::size_t v = y - (y > 0 ? 1 : 0); v < std::min(y + 2, height); ++v)
    for (std::size_t u = x - (x > 0 ? 1 : 0); u < std::min(x + 2, width); ++u) act(v * width + u);
}

/// Marks the pixels that differ from one of those around them by more than `contrast`.
void mark_edges(const ImageF& picture, double contrast, const Apart& apart, std::vector<char>& edges) {
  for (std::size_t i = 0; i < edges.size(); ++i)
    for_each_near(picture, i, [&](std::size_t near) {
      // Each pair of neighbours once.
      if (near > i && apart(pixel_of(picture, i), pixel_of(picture, near)).largest > contrast)
        edges[i] = edges[near] = 1;
    });
}

/// The difference of a pixel to the closest of those around the i-th of another picture.
PixelDifference least(const float* from, const ImageF& to, std::size_t i, const Apart& apart) {
  PixelDifference result = apart(from, pixel_of(to, i));
  for_each_near(to, i, [&](std::size_t near) {
    const PixelDifference difference = apart(from, pixel_of(to, near));
    if (difference.state != State::non_finite && difference.largest < result.largest) result = difference;
  });
  return result;
}

/// Makes differences at edges smaller as `Comparing::edge_tolerance` says; `range` is the whole range.
void forgive_edges(const ImageF& reference, const ImageF& image, double range, const Apart& apart,
                   Pixels& pixels) {
  const auto matters = [&](const PixelDifference& pixel) { return pixel.largest > least_forgiven * range; };
  if (std::none_of(pixels.begin(), pixels.end(), matters)) return;
  std::vector<char> is_edge(pixels.size(), 0);
  mark_edges(reference, edge_contrast * range, apart, is_edge);
  mark_edges(image, edge_contrast * range, apart, is_edge);
  std::vector<std::pair<std::size_t, PixelDifference>> forgiven;
  long long edges = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const PixelDifference& own = pixels[i];
    if (own.state != State::compared || is_edge[i] == 0) continue;
    ++edges;
    if (!matters(own)) continue;
    const PixelDifference from_a = least(pixel_of(reference, i), image, i, apart),
                          from_b = least(pixel_of(image, i), reference, i, apart);
    const PixelDifference& worse = from_a.largest > from_b.largest ? from_a : from_b;
    if (worse.largest >= own.largest) continue;
    forgiven.emplace_back(
        i, PixelDifference{State::compared, worse.largest, std::min(worse.sum, own.sum), true});
  }
  if (static_cast<double>(forgiven.size()) > most_forgiven * static_cast<double>(edges)) return;
  for (const auto& [i, pixel] : forgiven) pixels[i] = pixel;
}

/// Takes away differences as `Comparing::moved_pixels` says.
void forgive_moved(const ImageF& reference, double moved_pixels, const Apart& apart, Pixels& pixels) {
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    PixelDifference& pixel = pixels[i];
    if (pixel.state != State::compared || pixel.largest == 0) continue;
    double steepest = 0;
    for_each_near(reference, i, [&](std::size_t near) {
      const PixelDifference step = apart(pixel_of(reference, i), pixel_of(reference, near));
      if (step.state == State::compared) steepest = std::max(steepest, step.largest);
    });
    if (pixel.largest <= moved_pixels * steepest) pixel = {State::compared, 0, 0, true};
  }
}

/// How far the finite values of both pictures spread, as the difference of two pixels: one has the smallest
/// of each channel, one the largest.
double spread(const ImageF& a, const ImageF& b, const Apart& apart) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  const auto channels = static_cast<std::size_t>(a.channels);
  std::vector<float> low(channels, infinity), high(channels, -infinity);
  for (const ImageF* picture : {&a, &b})
    for (std::size_t i = 0; i < picture->samples.size(); ++i) {
      const float value = picture->samples[i];
      if (!std::isfinite(value)) continue;
      low[i % channels] = std::min(low[i % channels], value);
      high[i % channels] = std::max(high[i % channels], value);
    }
  return apart(low.data(), high.data()).largest;
}

/// The difference of every pixel that the mask lets through. `range` is the whole range of values; where it
/// is 0, the pictures tell it.
Pixels differences(const ImageF& reference, const ImageF& image, const Comparing& comparing, double range) {
  check_sizes(reference, image, comparing.mask);
  const Apart apart{comparing, comparing.in_degrees ? 3 : reference.channels};
  if (reference.channels != image.channels || image.channels < apart.channels)
    throw Error::failed(fmt::format("pictures of {} and {} channels cannot be compared{}", reference.channels,
                                    image.channels, comparing.in_degrees ? " as directions" : ""),
                        {}, "draw the same view for both");
  Pixels pixels;
  pixels.reserve(static_cast<std::size_t>(reference.width) * static_cast<std::size_t>(reference.height));
  bool any = false;
  for (int y = 0; y < reference.height; ++y)
    for (int x = 0; x < reference.width; ++x) {
      const bool counted = counts(comparing.mask, x, y);
      any |= counted;
      pixels.push_back(counted ? apart(&reference.at(x, y), &image.at(x, y))
                               : PixelDifference{State::left_out});
    }
  check_any(any);
  if (comparing.edge_tolerance) {
    if (range == 0) range = comparing.in_degrees ? 180 : spread(reference, image, apart);
    forgive_edges(reference, image, range, apart, pixels);
  }
  if (comparing.moved_pixels > 0) forgive_moved(reference, comparing.moved_pixels, apart, pixels);
  return pixels;
}

/// R, G and B as floats.
ImageF floats_of(const Image8& picture) {
  ImageF floats(picture.width, picture.height, 3);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int c = 0; c < 3; ++c) floats.at(x, y, c) = rgb_sample(picture, x, y, c);
  return floats;
}

/// The figures of all pixels; `range` as for `differences`.
Difference figures_of(const ImageF& reference, const ImageF& image, const Comparing& comparing,
                      double range) {
  const Pixels pixels = differences(reference, image, comparing, range);
  Difference result{image.width, image.height};
  std::vector<double> largest;
  double sum = 0;
  for (const PixelDifference& pixel : pixels) {
    result.pixels.push_back(pixel.state == State::non_finite ? std::numeric_limits<double>::quiet_NaN()
                                                             : pixel.largest);
    if (pixel.state == State::non_finite) ++result.non_finite;
    if (pixel.forgiven) ++result.forgiven;
    if (pixel.state != State::compared) continue;
    result.max = std::max(result.max, pixel.largest);
    largest.push_back(pixel.largest);
    sum += pixel.sum;
  }
  if (largest.empty()) return result;
  const auto percentile = [&](std::size_t per_mille) {
    const auto rank =
        largest.begin() + static_cast<std::ptrdiff_t>(index_of_per_mille(largest.size(), per_mille));
    std::nth_element(largest.begin(), rank, largest.end());
    return *rank;
  };
  result.p99 = percentile(990);
  result.p999 = percentile(999);
  const double told = std::isnan(comparing.told) ? result.p999 : comparing.told;
  double closest = HUGE_VAL;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    // What was forgiven is not what the pixel shows.
    const double apart = std::abs(pixels[i].largest - told);
    if (pixels[i].state != State::compared || pixels[i].forgiven || apart >= closest) continue;
    closest = apart;
    result.telling_x = static_cast<int>(i) % image.width;
    result.telling_y = static_cast<int>(i) / image.width;
  }
  const int samples_per_pixel = comparing.in_degrees ? 1 : image.channels;
  result.mean = sum / static_cast<double>(largest.size()) / samples_per_pixel;
  return result;
}

}  // namespace

Difference compare(const Image8& reference, const Image8& image, Comparing comparing) {
  comparing.in_degrees = false;
  return figures_of(floats_of(reference), floats_of(image), comparing, 255);
}

Difference compare(const ImageF& reference, const ImageF& image, const Comparing& comparing) {
  return figures_of(reference, image, comparing, 0);
}

Image8 heatmap(const Difference& difference, double full_scale) {
  if (full_scale <= 0) full_scale = difference.max;
  Image8 result(difference.width, difference.height, 3);
  std::uint8_t* out = result.samples.data();
  for (const double pixel : difference.pixels)
    for (const float value : heat(static_cast<float>(full_scale > 0 ? pixel / full_scale : pixel)))
      *out++ = to_encoding8(value, Encoding::linear);
  return result;
}

}  // namespace texel::image
