// SPDX-License-Identifier: MIT
#include "plain_flip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace texel::image {

double plain_linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

Vector plain_xyz(const Vector& rgb) {
  return {(10135552 * rgb[0] + 8788810 * rgb[1] + 4435075 * rgb[2]) / 24577794,
          (2613072 * rgb[0] + 8788810 * rgb[1] + 887015 * rgb[2]) / 12288897,
          (1425312 * rgb[0] + 8788810 * rgb[1] + 70074185 * rgb[2]) / 73733382};
}

Vector plain_hunt_lab(const Vector& rgb) {
  const auto f = [](double t) {
    const double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
  };
  const Vector xyz = plain_xyz(rgb) / white_xyz;
  const double x = f(xyz.x), y = f(xyz.y), z = f(xyz.z);
  const double lightness = 116 * y - 16;
  return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

double plain_hyab(const Vector& a, const Vector& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

double plain_color_error(double distance) {
  static const double largest =
      std::pow(plain_hyab(plain_hunt_lab({0, 1, 0}), plain_hunt_lab({0, 0, 1})), 0.7);
  const double compressed = std::pow(distance, 0.7), knee = 0.4 * largest;
  return compressed < knee ? 0.95 / knee * compressed
                           : 0.95 + (compressed - knee) / (largest - knee) * (1 - 0.95);
}

namespace {

using Plane = std::vector<double>;    // of one channel, row after row
using Weights = std::vector<double>;  // along one axis, from -radius to radius
using Picture = std::vector<Vector>;  // three channels, row after row

/// One product of a filter along x and one along y; filters are sums of such.
struct Product {
  Weights along_x, along_y;
};
using Filter = std::vector<Product>;

int radius_of(const Filter& filter) {
  return static_cast<int>(filter[0].along_x.size() / 2);
}

/// `value(x)` for each x of -radius to radius.
template <class Value>
Weights sampled(int radius, const Value& value) {
  Weights weights;
  for (int x = -radius; x <= radius; ++x) weights.push_back(value(x));
  return weights;
}

/// The sum of all weights that are above 0, or of those below.
double sum_of(const Filter& filter, bool positive) {
  double sum = 0;
  const std::size_t size = filter[0].along_x.size();
  for (std::size_t v = 0; v < size; ++v)
    for (std::size_t u = 0; u < size; ++u) {
      double weight = 0;
      for (const Product& product : filter) weight += product.along_x[u] * product.along_y[v];
      if ((weight > 0) == positive) sum += weight;
    }
  return sum;
}

class Size {
 public:
  Size(int width, int height) : width_(width), height_(height) {}

  /// The filter at each pixel; beyond the border the picture goes on as its border pixels.
  [[nodiscard]] Plane filtered(const Plane& plane, const Filter& filter, PlainFilters kind) const {
    if (kind == PlainFilters::square) return filtered_by_square(plane, filter);
    Plane result(plane.size());
    for (const Product& product : filter) {
      const Plane rows = moved_sum(plane, product.along_x, 1, 0);
      const Plane both = moved_sum(rows, product.along_y, 0, 1);
      for (std::size_t i = 0; i < result.size(); ++i) result[i] += both[i];
    }
    return result;
  }

 private:
  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(std::clamp(y, 0, height_ - 1)) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(std::clamp(x, 0, width_ - 1));
  }

  /// The plane with `radius` repeated pixels on every side.
  [[nodiscard]] Plane padded(const Plane& plane, int radius) const {
    Plane result;
    result.reserve(static_cast<std::size_t>(width_ + 2 * radius) *
                   static_cast<std::size_t>(height_ + 2 * radius));
    for (int y = -radius; y < height_ + radius; ++y)
      for (int x = -radius; x < width_ + radius; ++x) result.push_back(plane[index(x, y)]);
    return result;
  }

  [[nodiscard]] Plane filtered_by_square(const Plane& plane, const Filter& filter) const {
    const int radius = radius_of(filter), size = 2 * radius + 1;
    std::vector<double> square(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    for (const Product& product : filter)
      for (std::size_t i = 0; i < square.size(); ++i)
        square[i] += product.along_y[i / static_cast<std::size_t>(size)] *
                     product.along_x[i % static_cast<std::size_t>(size)];
    const Plane wide = padded(plane, radius);
    const auto stride = static_cast<std::size_t>(width_ + 2 * radius);
    Plane result;
    result.reserve(plane.size());
    for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y)
      for (std::size_t x = 0; x < static_cast<std::size_t>(width_); ++x) {
        double sum = 0;
        const double* weight = square.data();
        for (std::size_t v = 0; v < static_cast<std::size_t>(size); ++v) {
          const double* row = &wide[(y + v) * stride + x];
          for (std::size_t u = 0; u < static_cast<std::size_t>(size); ++u) sum += *weight++ * row[u];
        }
        result.push_back(sum);
      }
    return result;
  }

  /// The weighted sum of the plane moved by (k step_x, k step_y) for k of -radius to radius.
  [[nodiscard]] Plane moved_sum(const Plane& plane, const Weights& weights, int step_x, int step_y) const {
    const int radius = static_cast<int>(weights.size() / 2);
    const Plane wide = padded(plane, radius);
    const auto stride = static_cast<std::size_t>(width_ + 2 * radius);
    Plane result(plane.size());
    for (int k = -radius; k <= radius; ++k) {
      const double weight = weights[static_cast<std::size_t>(k + radius)];
      for (std::size_t y = 0; y < static_cast<std::size_t>(height_); ++y) {
        const double* from = &wide[(y + static_cast<std::size_t>(radius + k * step_y)) * stride +
                                   static_cast<std::size_t>(radius + k * step_x)];
        double* to = &result[y * static_cast<std::size_t>(width_)];
        for (std::size_t x = 0; x < static_cast<std::size_t>(width_); ++x) to[x] += weight * from[x];
      }
    }
    return result;
  }

  int width_, height_;
};

/// One picture on its way through both pipelines.
class Seen {
 public:
  Seen(const Image8& picture, PlainFilters kind, double ppd)
      : size_(picture.width, picture.height), kind_(kind), ppd_(ppd) {
    for (Plane& plane : opponents_) plane.reserve(picture.samples.size());
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x) {
        Vector rgb{};
        for (int c = 0; c < 3; ++c)
          rgb[c] = plain_linear(picture.at(x, y, picture.channels < 3 ? 0 : c) / 255.0);
        const Vector xyz = plain_xyz(rgb) / white_xyz;
        opponents_[0].push_back(116 * xyz.y - 16);
        opponents_[1].push_back(500 * (xyz.x - xyz.y));
        opponents_[2].push_back(200 * (xyz.y - xyz.z));
      }
    see_colors();
    const double sigma = 0.5 * 0.082 * ppd_;
    edges = features([](double x) { return x; });
    points = features([&](double x) { return x * x / (sigma * sigma) - 1; });
  }

  Picture colors;  // L*a*b* with the Hunt effect
  Plane edges, points;

 private:
  void see_colors() {
    // a1, b1, a2, b2 of each channel: the paper's table 1.
    constexpr double table[3][4] = {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};
    constexpr double pi = std::numbers::pi;
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd_));
    std::array<Plane, 3> filtered;
    for (std::size_t c = 0; c < 3; ++c) {
      Filter filter;
      for (const std::size_t term : {0U, 2U}) {
        const double a = table[c][term], b = table[c][term + 1];
        if (a == 0) continue;
        const auto bell = [&](int x) { return std::exp(-pi * pi * x * x / (ppd_ * ppd_) / b); };
        filter.push_back({sampled(radius, bell), sampled(radius, bell)});
        for (double& weight : filter.back().along_y) weight *= a * std::sqrt(pi / b);
      }
      const double sum = sum_of(filter, true);
      for (Product& product : filter)
        for (double& weight : product.along_y) weight /= sum;
      filtered[c] = size_.filtered(opponents_[c], filter, kind_);
    }
    const glm::dmat3 rgb_of_xyz =
        glm::inverse(glm::dmat3(plain_xyz({1, 0, 0}), plain_xyz({0, 1, 0}), plain_xyz({0, 0, 1})));
    for (std::size_t i = 0; i < filtered[0].size(); ++i) {
      const double y = (filtered[0][i] + 16) / 116;
      const Vector rgb =
          rgb_of_xyz * (Vector(y + filtered[1][i] / 500, y, y - filtered[2][i] / 200) * white_xyz);
      colors.push_back(plain_hunt_lab(glm::clamp(rgb, 0.0, 1.0)));
    }
  }

  /// The length of a detector's answers along x and y: `profile(x)` times a Gaussian.
  template <class Profile>
  [[nodiscard]] Plane features(const Profile& profile) const {
    const double sigma = 0.5 * 0.082 * ppd_;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    const auto bell = [&](int x) { return std::exp(-x * x / (2 * sigma * sigma)); };
    const Weights smooth = sampled(radius, bell);
    Weights detector = sampled(radius, [&](int x) { return profile(x) * bell(x); });
    const double positive = sum_of({{detector, smooth}}, true),
                 negative = sum_of({{detector, smooth}}, false);
    for (double& weight : detector) weight /= weight > 0 ? positive : -negative;
    Plane light = opponents_[0];
    for (double& v : light) v = (v + 16) / 116;
    const Plane x = size_.filtered(light, {{detector, smooth}}, kind_),
                y = size_.filtered(light, {{smooth, detector}}, kind_);
    Plane lengths;
    lengths.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) lengths.push_back(std::hypot(x[i], y[i]));
    return lengths;
  }

  Size size_;
  PlainFilters kind_;
  double ppd_;
  std::array<Plane, 3> opponents_;
};

}  // namespace

std::vector<double> plain_flip(const Image8& reference, const Image8& image, PlainFilters filters,
                               double pixels_per_degree) {
  const Seen a(reference, filters, pixels_per_degree), b(image, filters, pixels_per_degree);
  std::vector<double> errors;
  errors.reserve(a.colors.size());
  for (std::size_t i = 0; i < a.colors.size(); ++i) {
    const double color = plain_color_error(plain_hyab(a.colors[i], b.colors[i]));
    const double edges = std::abs(a.edges[i] - b.edges[i]), points = std::abs(a.points[i] - b.points[i]);
    const double feature = std::sqrt(std::max(edges, points) / std::numbers::sqrt2);
    errors.push_back(std::pow(color, 1 - feature));
  }
  return errors;
}

}  // namespace texel::image
