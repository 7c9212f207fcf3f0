// SPDX-License-Identifier: MIT
// FLIP against a straightforward version in double precision, and against what is known by hand.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "core/error.hpp"
#include "image/flip.hpp"

namespace texel::image {
namespace {

using Vector = std::array<double, 3>;
using Picture = std::vector<Vector>;  // row after row

// ---- The paper in double precision: square filters, pixel by pixel, all constants as the paper has them
// ----

double linear(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

constexpr double kWhite[3] = {23359437.0 / 24577794, 1, 80288307.0 / 73733382};

Vector xyz_of(const Vector& rgb) {
  return {(10135552 * rgb[0] + 8788810 * rgb[1] + 4435075 * rgb[2]) / 24577794,
          (2613072 * rgb[0] + 8788810 * rgb[1] + 887015 * rgb[2]) / 12288897,
          (1425312 * rgb[0] + 8788810 * rgb[1] + 70074185 * rgb[2]) / 73733382};
}

Vector solve(const std::array<Vector, 3>& columns, const Vector& right) {
  const auto determinant = [](const Vector& a, const Vector& b, const Vector& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  const double whole = determinant(columns[0], columns[1], columns[2]);
  return {determinant(right, columns[1], columns[2]) / whole,
          determinant(columns[0], right, columns[2]) / whole,
          determinant(columns[0], columns[1], right) / whole};
}

Vector rgb_of(const Vector& xyz) {
  return solve({xyz_of({1, 0, 0}), xyz_of({0, 1, 0}), xyz_of({0, 0, 1})}, xyz);
}

Vector ycxcz_of(const Vector& xyz) {
  const double x = xyz[0] / kWhite[0], y = xyz[1], z = xyz[2] / kWhite[2];
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Vector xyz_of_ycxcz(const Vector& v) {
  const double y = (v[0] + 16) / 116;
  return {(y + v[1] / 500) * kWhite[0], y, (y - v[2] / 200) * kWhite[2]};
}

Vector hunt_of(const Vector& rgb) {
  const auto f = [](double t) {
    const double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
  };
  const Vector xyz = xyz_of(rgb);
  const double x = f(xyz[0] / kWhite[0]), y = f(xyz[1]), z = f(xyz[2] / kWhite[2]);
  const double lightness = 116 * y - 16;
  return {lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)};
}

double hyab(const Vector& a, const Vector& b) {
  return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
}

double redistributed(double distance) {
  const double largest = std::pow(hyab(hunt_of({0, 1, 0}), hunt_of({0, 0, 1})), 0.7);
  const double compressed = std::pow(distance, 0.7), knee = 0.4 * largest;
  return compressed < knee ? 0.95 / knee * compressed
                           : 0.95 + (compressed - knee) / (largest - knee) * (1 - 0.95);
}

/// FLIP of two constant colours (linear RGB): the filters leave constants, and there are no features.
double flip_of_colours(const Vector& a, const Vector& b) {
  return redistributed(hyab(hunt_of(a), hunt_of(b)));
}

class Straightforward {
 public:
  Straightforward(const Image8& reference, const Image8& image, double ppd)
      : width_(reference.width), height_(reference.height), ppd_(ppd) {
    const Picture a = opponents(reference), b = opponents(image);
    const Picture seen_a = seen(a), seen_b = seen(b);
    const auto edge = [](double x, double) { return x; };
    const auto point = [](double x, double sigma) { return x * x / (sigma * sigma) - 1; };
    const std::vector<double> edges_a = features(a, edge), edges_b = features(b, edge),
                              points_a = features(a, point), points_b = features(b, point);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const double color = redistributed(hyab(hunt_of(seen_a[i]), hunt_of(seen_b[i])));
      const double feature =
          std::sqrt(std::max(std::abs(edges_a[i] - edges_b[i]), std::abs(points_a[i] - points_b[i])) /
                    std::numbers::sqrt2);
      errors.push_back(std::pow(color, 1 - feature));
    }
  }
  std::vector<double> errors;

 private:
  using Weights = std::vector<double>;  // a square, row after row

  [[nodiscard]] Picture opponents(const Image8& picture) const {
    Picture result;
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        Vector rgb{};
        for (int c = 0; c < 3; ++c)
          rgb[static_cast<std::size_t>(c)] = linear(picture.at(x, y, picture.channels < 3 ? 0 : c) / 255.0);
        result.push_back(ycxcz_of(xyz_of(rgb)));
      }
    return result;
  }

  /// The weighted sum around each pixel of one channel.
  [[nodiscard]] std::vector<double> filtered(const Picture& picture, std::size_t channel,
                                             const Weights& weights, int radius) const {
    std::vector<double> result;
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        double sum = 0;
        std::size_t i = 0;
        for (int v = -radius; v <= radius; ++v)
          for (int u = -radius; u <= radius; ++u)
            sum +=
                weights[i++] * picture[static_cast<std::size_t>(std::clamp(y + v, 0, height_ - 1) * width_ +
                                                                std::clamp(x + u, 0, width_ - 1))][channel];
        result.push_back(sum);
      }
    return result;
  }

  [[nodiscard]] Picture seen(const Picture& picture) const {
    // a1, b1, a2, b2 of each channel: the paper's table 1.
    constexpr double table[3][4] = {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};
    constexpr double pi = std::numbers::pi;
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd_));
    Picture result(picture.size());
    for (std::size_t c = 0; c < 3; ++c) {
      const auto& [a1, b1, a2, b2] = table[c];
      Weights weights;
      double sum = 0;
      for (int v = -radius; v <= radius; ++v)
        for (int u = -radius; u <= radius; ++u) {
          const double square = (u * u + v * v) / (ppd_ * ppd_);
          weights.push_back(a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * square / b1) +
                            a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * square / b2));
          sum += weights.back();
        }
      for (double& weight : weights) weight /= sum;
      const std::vector<double> values = filtered(picture, c, weights, radius);
      for (std::size_t i = 0; i < values.size(); ++i) result[i][c] = values[i];
    }
    for (Vector& v : result) {
      v = rgb_of(xyz_of_ycxcz(v));
      for (double& value : v) value = std::clamp(value, 0.0, 1.0);
    }
    return result;
  }

  /// The length of a detector's answers along x and y: `profile(x, sigma)` times a Gaussian.
  [[nodiscard]] std::vector<double> features(const Picture& picture,
                                             const std::function<double(double, double)>& profile) const {
    const double sigma = 0.5 * 0.082 * ppd_;
    const int radius = static_cast<int>(std::ceil(3 * sigma));
    Weights along_x, along_y;
    double positive = 0, negative = 0;
    for (int v = -radius; v <= radius; ++v)
      for (int u = -radius; u <= radius; ++u) {
        const double bell = std::exp(-(u * u + v * v) / (2 * sigma * sigma));
        along_x.push_back(profile(u, sigma) * bell);
        along_y.push_back(profile(v, sigma) * bell);
        (along_x.back() > 0 ? positive : negative) += along_x.back();
      }
    for (Weights* weights : {&along_x, &along_y})
      for (double& weight : *weights) weight /= weight > 0 ? positive : -negative;
    Picture light = picture;
    for (Vector& v : light) v[0] = (v[0] + 16) / 116;
    const std::vector<double> x = filtered(light, 0, along_x, radius),
                              y = filtered(light, 0, along_y, radius);
    std::vector<double> result;
    for (std::size_t i = 0; i < x.size(); ++i) result.push_back(std::hypot(x[i], y[i]));
    return result;
  }

  int width_, height_;
  double ppd_;
};

// ---- Pictures ----

Image8 constant(int width, int height, std::array<std::uint8_t, 3> rgb) {
  Image8 picture(width, height, 3);
  for (std::size_t i = 0; i < picture.samples.size(); ++i) picture.samples[i] = rgb[i % 3];
  return picture;
}

/// A hash of a number, 0..255, the same everywhere.
int noise(unsigned n) {
  n = (n ^ 61U) ^ (n >> 16U);
  n *= 9U;
  n ^= n >> 4U;
  n *= 0x27d4eb2dU;
  n ^= n >> 15U;
  return static_cast<int>(n & 255U);
}

/// Soft colours, a disc with a hard edge, fine stripes on the right, dots at the top and some noise.
Image8 scene(int width, int height, int shift = 0) {
  Image8 picture(width, height, 3);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int s = x + shift;
      std::array<double, 3> rgb = {120 + 100 * std::sin(0.13 * s), 90 + 60 * std::cos(0.07 * (s + y)),
                                   128 + 127 * std::sin(0.05 * y)};
      if (std::hypot(s - 0.4 * width, y - 0.5 * height) < 0.25 * width) rgb = {250, 220, 10};
      if (s > 0.75 * width && s % 3 == 0) rgb = {5, 5, 40};
      if (y > 0.85 * height && s % 7 == 0 && y % 5 == 0) rgb = {255, 255, 255};
      for (int c = 0; c < 3; ++c)
        picture.at(x, y, c) = static_cast<std::uint8_t>(std::clamp(
            rgb[static_cast<std::size_t>(c)] + noise(static_cast<unsigned>(3 * (y * 997 + s) + c)) / 32, 0.0,
            255.0));
    }
  return picture;
}

Image8 changed(Image8 picture, const std::function<int(int sample, std::size_t i)>& change) {
  for (std::size_t i = 0; i < picture.samples.size(); ++i)
    picture.samples[i] = static_cast<std::uint8_t>(std::clamp(change(picture.samples[i], i), 0, 255));
  return picture;
}

Image8 mirrored(const Image8& picture) {
  Image8 result(picture.width, picture.height, picture.channels);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int c = 0; c < picture.channels; ++c) result.at(x, y, c) = picture.at(picture.width - 1 - x, y, c);
  return result;
}

/// Columns below `edge` black, the others white.
Image8 step(int width, int height, int edge) {
  Image8 picture(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = edge; x < width; ++x) picture.at(x, y) = 255;
  return picture;
}

std::string error_of(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), Exit::failed);
    return error.what();
  }
  return "";
}

/// The largest difference of the fast errors from those in double precision.
double distance_to_straightforward(const Image8& a, const Image8& b, double ppd = default_pixels_per_degree) {
  const ImageF fast = flip_errors(a, b, ppd);
  const Straightforward slow(a, b, ppd);
  double largest = 0;
  for (std::size_t i = 0; i < slow.errors.size(); ++i)
    largest = std::max(largest, std::abs(slow.errors[i] - static_cast<double>(fast.samples[i])));
  return largest;
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
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(xyz_of(one)[i], luminances[c] * primaries[c][i], 1e-7);
    EXPECT_NEAR(white[c], kWhite[c], 1e-7);
  }
}

TEST(FlipConstants, see_the_pictures_at_67_pixels_a_degree) {
  // In the middle of the display a pixel of 0.7 m / 3840 is seen from 0.7 m.
  EXPECT_NEAR(default_pixels_per_degree, 67.02, 0.005);
}

TEST(Flip, is_the_redistributed_distance_for_constant_colours) {
  const std::array<std::array<std::uint8_t, 3>, 9> colours = {{{0, 0, 0},
                                                               {255, 255, 255},
                                                               {0, 255, 0},
                                                               {0, 0, 255},
                                                               {255, 0, 0},
                                                               {128, 128, 128},
                                                               {129, 128, 128},
                                                               {10, 200, 240},
                                                               {250, 240, 5}}};
  const auto linear_of = [](const std::array<std::uint8_t, 3>& rgb) {
    return Vector{linear(rgb[0] / 255.0), linear(rgb[1] / 255.0), linear(rgb[2] / 255.0)};
  };
  for (const auto& a : colours)
    for (const auto& b : colours) {
      const ImageF errors = flip_errors(constant(40, 30, a), constant(40, 30, b));
      const double expected = flip_of_colours(linear_of(a), linear_of(b));
      // Floats: lightness to 1e-5 of 100, and the compressed distance is steepest near 0.
      for (const float error : errors.samples) ASSERT_NEAR(error, expected, 2e-5);
    }
}

TEST(Flip, is_known_for_black_and_white_and_for_green_and_blue) {
  // Black and white: L* 0 and 100, HyAB 100. Green and blue are the largest distance, so that FLIP is 1.
  const double black_white =
      flip_figures(flip_errors(constant(8, 8, {0, 0, 0}), constant(8, 8, {255, 255, 255}))).mean;
  const double largest = hyab(hunt_of({0, 1, 0}), hunt_of({0, 0, 1}));
  EXPECT_NEAR(largest, 203.30, 0.005);
  const double part = std::pow(100 / largest, 0.7);  // 0.609, above p_c
  EXPECT_NEAR(black_white, 0.95 + 0.05 * (part - 0.4) / 0.6, 1e-6);
  EXPECT_NEAR(flip_figures(flip_errors(constant(8, 8, {0, 255, 0}), constant(8, 8, {0, 0, 255}))).mean, 1,
              1e-6);
}

// ---- Whole pictures ----

TEST(Flip, agrees_with_the_straightforward_version) {
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
    EXPECT_LT(distance_to_straightforward(reference, others[i]), 1e-4) << i;
  }
  // Measured: 9.4e-5, where white beside the edge is nearly white in both.
  EXPECT_LT(distance_to_straightforward(step(50, 40, 20), step(50, 40, 21)), 1e-4);
}

TEST(Flip, agrees_at_other_distances_and_in_small_pictures) {
  for (const double ppd : {1.0, 12.0, 30.0, 110.0})
    EXPECT_LT(distance_to_straightforward(scene(33, 21), scene(33, 21, 2), ppd), 1e-4) << ppd;
  for (const auto& [width, height] : {std::pair{1, 1}, {1, 9}, {5, 2}, {17, 16}})
    EXPECT_LT(distance_to_straightforward(scene(width, height), scene(width, height, 1)), 1e-4) << width;
}

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

TEST(FlipHeatmap, has_the_colours_of_magma) {
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
