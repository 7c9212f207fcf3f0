// SPDX-License-Identifier: MIT
// FLIP (Andersson et al. 2020). The paper's parts are named by its headings.
#include "perception/perception.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <vector>

#include "filter.hpp"
#include "image/color.hpp"
#include "image/comparison.hpp"

namespace texel::perception {
namespace {

using image::Image8;
using image::ImageF;

using Plane = ImageF;  // of one channel
using Triple = std::array<float, 3>;
using Matrix = std::array<Triple, 3>;

// ---- Colour ----

/// X, Y and Z of linear sRGB, each divided by the white's (D65), so that white is (1, 1, 1): the rows of the
/// standard's matrix (IEC 61966-2-1, from its primaries and white) divided by their sums; and its inverse.
constexpr Matrix xyz_from_rgb = {Triple{0.433895389F, 0.376242373F, 0.189862239F},
                                 {0.212636822F, 0.715182982F, 0.072180196F},
                                 {0.017752423F, 0.109465629F, 0.872781948F}};
constexpr Matrix rgb_from_xyz = {Triple{3.080341988F, -1.537398969F, -0.542943019F},
                                 {-0.921178396F, 1.875929984F, 0.045248412F},
                                 {0.052881293F, -0.204011206F, 1.151129913F}};

inline Triple product(const Matrix& m, const Triple& v) {
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return result;
}

/// The cube root of a float of about 0.01 to 1, which takes a fifth of std::cbrt's time: a third of the bits
/// is a guess (the exponent is in front) with an error below 7 %, and each of two of Halley's steps cubes it.
inline float cube_root(float v) {
  constexpr std::uint32_t two_thirds_of_the_bias = 2 * (127U << 23U) / 3;
  float root = std::bit_cast<float>(std::bit_cast<std::uint32_t>(v) / 3 + two_thirds_of_the_bias);
  for (int step = 0; step < 2; ++step) {
    const float cube = root * root * root;
    root *= (cube + 2 * v) / (2 * cube + v);
  }
  return root;
}

/// CIE's function between XYZ relative to white and L*a*b*.
inline float lab_curve(float t) {
  constexpr float knee = 6.0F / 29;
  const float root = cube_root(t), line = t / (3 * knee * knee) + 4.0F / 29;  // a branch costs more
  return t > knee * knee * knee ? root : line;
}

/// CIE L*a*b*, with a* and b* scaled by the Hunt effect: colours are less colourful where it is dark
/// ("Perceptually uniform colour space").
inline Triple hunt_lab(const Triple& linear_rgb) {
  const Triple xyz = product(xyz_from_rgb, linear_rgb);
  const float x = lab_curve(xyz[0]), y = lab_curve(xyz[1]), z = lab_curve(xyz[2]);
  const float lightness = 116 * y - 16;
  return {lightness, 0.01F * lightness * 500 * (x - y), 0.01F * lightness * 200 * (y - z)};
}

/// The distance HyAB: along lightness and across it apart, which suits large differences ("Colour metric").
float hyab(const Triple& a, const Triple& b) {
  const float across_a = a[1] - b[1], across_b = a[2] - b[2];
  return std::abs(a[0] - b[0]) + std::sqrt(across_a * across_a + across_b * across_b);
}

/// A HyAB distance as an error of 0 to 1 ("Colour metric"): raised to q_c, which compresses large distances;
/// then those up to p_c of the largest that sRGB has, from green to blue, share 0 to p_t evenly, and the few
/// beyond the rest.
float color_error(float distance) {
  constexpr float q_c = 0.7F, p_c = 0.4F, p_t = 0.95F;
  static const float largest = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), q_c);
  const float compressed = std::pow(distance, q_c), knee = p_c * largest;
  if (compressed < knee) return p_t / knee * compressed;
  return p_t + (1 - p_t) * std::min(1.0F, (compressed - knee) / (largest - knee));
}

// ---- Filters ----

/// The filters of both pipelines, each as its kernel along rows and the one along columns.
struct Filters {
  using Kernel = perception::Kernel<float>;
  // "Spatial filtering": the eye's contrast sensitivity to each opponent channel, as a sum of Gaussians
  // a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees. Blue-yellow has two, the others one.
  Kernel luminance, red_green;
  Kernel wide_rows, wide_columns, narrow_rows, narrow_columns;  ///< blue-yellow's two
  // "Feature detection": a Gaussian and its first and second derivative.
  Kernel smooth, slope, curvature;

  Filters() {
    constexpr double b_luminance = 0.0047, b_red_green = 0.0053;
    constexpr double a_wide = 34.1, b_wide = 0.04, a_narrow = 13.5, b_narrow = 0.025;
    const auto sigma = [&](double b) { return std::sqrt(b / 2) / std::numbers::pi * pixels_per_degree; };
    const int color_radius = static_cast<int>(std::ceil(3 * sigma(b_wide)));
    luminance = even_kernel<float>(gaussian(sigma(b_luminance), color_radius));
    red_green = even_kernel<float>(gaussian(sigma(b_red_green), color_radius));
    const std::vector<double> wide = gaussian(sigma(b_wide), color_radius);
    const std::vector<double> narrow = gaussian(sigma(b_narrow), color_radius);
    // What each of the two adds to the sum of all weights of the square filter.
    const auto volume = [](double a, double b, const std::vector<double>& weights) {
      return a * std::sqrt(std::numbers::pi / b) * sum_of(weights) * sum_of(weights);
    };
    const double wide_volume = volume(a_wide, b_wide, wide);
    const double narrow_volume = volume(a_narrow, b_narrow, narrow);
    wide_rows = even_kernel<float>(wide);
    wide_columns = even_kernel<float>(wide, wide_volume / (wide_volume + narrow_volume));
    narrow_rows = even_kernel<float>(narrow);
    narrow_columns = even_kernel<float>(narrow, narrow_volume / (wide_volume + narrow_volume));

    constexpr double peak_to_trough = 0.082;  // degrees, of the eye's edge detector: twice its sigma
    const double feature_sigma = 0.5 * peak_to_trough * pixels_per_degree;
    const int feature_radius = static_cast<int>(std::ceil(3 * feature_sigma));
    const std::vector<double> bell = gaussian(feature_sigma, feature_radius);
    smooth = even_kernel<float>(bell);
    make_derivatives(feature_sigma, bell);
  }

 private:
  /// Both are scaled so that the positive weights add up to 1 and the negative ones to -1.
  void make_derivatives(double sigma, const std::vector<double>& bell) {
    std::vector<double> first, second;
    for (std::size_t k = 0; k < bell.size(); ++k) {
      const auto x = static_cast<double>(k);
      first.push_back(x * bell[k]);
      second.push_back((x * x / (sigma * sigma) - 1) * bell[k]);
    }
    const double first_sum = std::accumulate(first.begin(), first.end(), 0.0);
    double positive = 0, negative = second[0];
    for (std::size_t k = 1; k < second.size(); ++k) (second[k] > 0 ? positive : negative) += 2 * second[k];
    slope.symmetry = Symmetry::odd;
    curvature.symmetry = Symmetry::zero_sum;
    for (const double weight : first) slope.weights.push_back(static_cast<float>(weight / first_sum));
    for (const double weight : second)
      curvature.weights.push_back(static_cast<float>(weight > 0 ? weight / positive : weight / -negative));
  }
};

// ---- One picture ----

/// By value: a reference, as std::clamp takes, would keep the loop below from becoming vector instructions.
inline float clamped(float v) {
  const float positive = v < 0 ? 0 : v;
  return positive > 1 ? 1 : positive;
}

/// A picture behind all filters.
struct Seen {
  Plane lightness, a, b;  ///< the colour pipeline, as `hunt_lab`
  Plane edges, points;    ///< the feature pipeline: how much there is of each
};

/// How strong a feature is, from what its detector says along x and along y.
Plane strength(Plane along_x, const Plane& along_y) {
  for (std::size_t i = 0; i < along_x.samples.size(); ++i) {
    const float x = along_x.samples[i], y = along_y.samples[i];
    along_x.samples[i] = std::sqrt(x * x + y * y);
  }
  return along_x;
}

/// The opponent channels are y, x - y and y - z of XYZ relative to white. The paper's are Y_y = 116 y - 16,
/// c_x = 500 (x - y) and c_z = 200 (y - z): the same to filters whose weights add up to 1.
Seen see(const Image8& picture, const Filters& f) {
  Plane light(picture.width, picture.height, 1), red_green = light, blue_yellow = light;
  std::array<float, 256> light_of{};
  for (std::size_t i = 0; i < light_of.size(); ++i)
    light_of[i] = image::from_encoding8(static_cast<std::uint8_t>(i));
  const std::size_t green = picture.channels < 3 ? 0 : 1, blue = 2 * green;
  const std::uint8_t* rgb = picture.samples.data();
  for (std::size_t i = 0; i < light.samples.size(); ++i, rgb += picture.channels) {
    const Triple xyz = product(xyz_from_rgb, {light_of[rgb[0]], light_of[rgb[green]], light_of[rgb[blue]]});
    light.samples[i] = xyz[1];
    red_green.samples[i] = xyz[0] - xyz[1];
    blue_yellow.samples[i] = xyz[1] - xyz[2];
  }
  Seen seen = {filtered(light, f.luminance, f.luminance), filtered(red_green, f.red_green, f.red_green),
               filtered(blue_yellow, f.wide_rows, f.wide_columns),
               strength(filtered(light, f.slope, f.smooth), filtered(light, f.smooth, f.slope)),
               strength(filtered(light, f.curvature, f.smooth), filtered(light, f.smooth, f.curvature))};
  const Plane narrow = filtered(blue_yellow, f.narrow_rows, f.narrow_columns);
  float *const lightness = seen.lightness.samples.data(), *const a = seen.a.samples.data(),
               *const b = seen.b.samples.data();
  for (std::size_t i = 0; i < narrow.samples.size(); ++i) {
    b[i] += narrow.samples[i];
    const Triple linear = product(rgb_from_xyz, {lightness[i] + a[i], lightness[i], lightness[i] - b[i]});
    // As far as sRGB can show the colours.
    const Triple lab = hunt_lab({clamped(linear[0]), clamped(linear[1]), clamped(linear[2])});
    lightness[i] = lab[0], a[i] = lab[1], b[i] = lab[2];
  }
  return seen;
}

// ---- Both ----

/// "Final difference" of the i-th pixel: features raise the colours' error.
float error_at(const Seen& a, const Seen& b, std::size_t i) {
  const float distance = hyab({a.lightness.samples[i], a.a.samples[i], a.b.samples[i]},
                              {b.lightness.samples[i], b.a.samples[i], b.b.samples[i]});
  if (distance == 0) return 0;
  // "Feature metric": how much more of an edge or of a point the one picture has, raised to q_f = 1/2.
  const float edges = a.edges.samples[i] - b.edges.samples[i];
  const float points = a.points.samples[i] - b.points.samples[i];
  const float feature = std::sqrt(std::max(std::abs(edges), std::abs(points)) / std::numbers::sqrt2_v<float>);
  return std::pow(color_error(distance), 1 - feature);
}

}  // namespace

ImageF flip_errors(const Image8& reference, const Image8& image) {
  check_sizes(reference, image, nullptr);
  image::check_any(!reference.samples.empty());
  const Filters filters;
  const Seen a = see(reference, filters), b = see(image, filters);
  ImageF errors(reference.width, reference.height, 1);
  for (std::size_t i = 0; i < errors.samples.size(); ++i) errors.samples[i] = error_at(a, b, i);
  return errors;
}

FlipFigures flip_figures(const ImageF& errors, const Image8* mask) {
  check_sizes(errors, errors, mask);
  std::vector<float> counted;
  for (int y = 0; y < errors.height; ++y)
    for (int x = 0; x < errors.width; ++x)
      if (counts(mask, x, y)) counted.push_back(errors.at(x, y));
  image::check_any(!counted.empty());
  std::sort(counted.begin(), counted.end());
  const double sum = std::accumulate(counted.begin(), counted.end(), 0.0);
  return {sum / static_cast<double>(counted.size()), counted[image::index_of_per_mille(counted.size(), 990)]};
}

}  // namespace texel::perception
