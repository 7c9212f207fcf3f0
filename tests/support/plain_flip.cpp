// SPDX-License-Identifier: MIT
#include "plain_flip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace texel::perception {

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

using Plane = image::Image<double>;   // of one channel
using Weights = std::vector<double>;  // along one axis, from -radius to radius

/// One product of a filter along x and one along y; filters are sums of such.
struct Product {
  Weights along_x, along_y;
};
using Filter = std::vector<Product>;

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

/// The weighted sum of the pixels (k step_x, k step_y) away; beyond the border the picture goes on as its
/// border pixels.
Plane filtered_along(const Plane& plane, const Weights& weights, int step_x, int step_y) {
  Plane result(plane.width, plane.height, 1);
  const int radius = static_cast<int>(weights.size() / 2);
  for (int k = -radius; k <= radius; ++k)
    for (int y = 0; y < plane.height; ++y)
      for (int x = 0; x < plane.width; ++x)
        result.at(x, y) += weights[static_cast<std::size_t>(k + radius)] *
                           plane.at(std::clamp(x + k * step_x, 0, plane.width - 1),
                                    std::clamp(y + k * step_y, 0, plane.height - 1));
  return result;
}

Plane filtered(const Plane& plane, const Filter& filter) {
  Plane result(plane.width, plane.height, 1);
  for (const Product& product : filter) {
    const Plane both = filtered_along(filtered_along(plane, product.along_x, 1, 0), product.along_y, 0, 1);
    for (std::size_t i = 0; i < result.samples.size(); ++i) result.samples[i] += both.samples[i];
  }
  return result;
}

/// The opponent channels 116 y - 16, 500 (x - y) and 200 (y - z) of XYZ relative to white.
std::array<Plane, 3> opponents_of(const Image8& picture) {
  std::array<Plane, 3> opponents;
  opponents.fill(Plane(picture.width, picture.height, 1));
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      Vector rgb{};
      for (int c = 0; c < 3; ++c)
        rgb[c] = plain_linear(picture.at(x, y, picture.channels < 3 ? 0 : c) / 255.0);
      const Vector xyz = plain_xyz(rgb) / white_xyz;
      opponents[0].at(x, y) = 116 * xyz.y - 16;
      opponents[1].at(x, y) = 500 * (xyz.x - xyz.y);
      opponents[2].at(x, y) = 200 * (xyz.y - xyz.z);
    }
  return opponents;
}

/// L*a*b* with the Hunt effect, of the colours as the eye sees them.
std::vector<Vector> seen_colors(const std::array<Plane, 3>& opponents) {
  // a1, b1, a2, b2 of each channel: the paper's table 1.
  constexpr double table[3][4] = {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};
  constexpr double pi = std::numbers::pi, ppd = pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd));
  std::array<Plane, 3> seen;
  for (std::size_t c = 0; c < 3; ++c) {
    Filter filter;
    for (const std::size_t term : {0U, 2U}) {
      const double a = table[c][term], b = table[c][term + 1];
      if (a == 0) continue;
      const auto bell = [&](int x) { return std::exp(-pi * pi * x * x / (ppd * ppd) / b); };
      filter.push_back({sampled(radius, bell), sampled(radius, bell)});
      for (double& weight : filter.back().along_y) weight *= a * std::sqrt(pi / b);
    }
    const double sum = sum_of(filter, true);
    for (Product& product : filter)
      for (double& weight : product.along_y) weight /= sum;
    seen[c] = filtered(opponents[c], filter);
  }
  const glm::dmat3 rgb_of_xyz =
      glm::inverse(glm::dmat3(plain_xyz({1, 0, 0}), plain_xyz({0, 1, 0}), plain_xyz({0, 0, 1})));
  std::vector<Vector> colors;
  for (std::size_t i = 0; i < seen[0].samples.size(); ++i) {
    const double y = (seen[0].samples[i] + 16) / 116;
    const Vector xyz(y + seen[1].samples[i] / 500, y, y - seen[2].samples[i] / 200);
    colors.push_back(plain_hunt_lab(glm::clamp(rgb_of_xyz * (xyz * white_xyz), 0.0, 1.0)));
  }
  return colors;
}

constexpr double detector_sigma = 0.5 * 0.082 * pixels_per_degree;

/// The length of a detector's answers along x and y: `profile(x)` times a Gaussian.
template <class Profile>
std::vector<double> features(Plane light, const Profile& profile) {
  const int radius = static_cast<int>(std::ceil(3 * detector_sigma));
  const auto bell = [](int x) { return std::exp(-x * x / (2 * detector_sigma * detector_sigma)); };
  const Weights smooth = sampled(radius, bell);
  Weights detector = sampled(radius, [&](int x) { return profile(x) * bell(x); });
  const double positive = sum_of({{detector, smooth}}, true), negative = sum_of({{detector, smooth}}, false);
  for (double& weight : detector) weight /= weight > 0 ? positive : -negative;
  for (double& v : light.samples) v = (v + 16) / 116;
  const Plane x = filtered(light, {{detector, smooth}}), y = filtered(light, {{smooth, detector}});
  std::vector<double> lengths;
  for (std::size_t i = 0; i < x.samples.size(); ++i)
    lengths.push_back(std::hypot(x.samples[i], y.samples[i]));
  return lengths;
}

/// One picture behind both pipelines.
struct Seen {
  explicit Seen(const std::array<Plane, 3>& opponents)
      : colors(seen_colors(opponents)),
        edges(features(opponents[0], [](double x) { return x; })),
        points(
            features(opponents[0], [](double x) { return x * x / (detector_sigma * detector_sigma) - 1; })) {}

  std::vector<Vector> colors;
  std::vector<double> edges, points;
};

}  // namespace

std::vector<double> plain_flip(const Image8& reference, const Image8& image) {
  const Seen a(opponents_of(reference)), b(opponents_of(image));
  std::vector<double> errors;
  for (std::size_t i = 0; i < a.colors.size(); ++i) {
    const double color = plain_color_error(plain_hyab(a.colors[i], b.colors[i]));
    const double edges = std::abs(a.edges[i] - b.edges[i]), points = std::abs(a.points[i] - b.points[i]);
    const double feature = std::sqrt(std::max(edges, points) / std::numbers::sqrt2);
    errors.push_back(std::pow(color, 1 - feature));
  }
  return errors;
}

}  // namespace texel::perception
