// SPDX-License-Identifier: MIT
// FLIP (Andersson et al. 2020). The paper's parts are named by its headings.
#include "image/flip.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "comparison.hpp"
#include "filter.hpp"
#include "image/color.hpp"

namespace texel::image {
namespace {

using Plane = ImageF;  // of one channel
using Vector = std::array<double, 3>;
using Matrix = std::array<Vector, 3>;

// ---- Colour ----

/// X, Y and Z of linear sRGB, each divided by the white's (D65), so that white is (1, 1, 1): the rows of the
/// standard's matrix (IEC 61966-2-1, from its primaries and white) divided by their sums.
constexpr Matrix make_xyz_from_rgb() {
  Matrix m = {Vector{10135552, 8788810, 4435075}, Vector{2613072, 8788810, 887015},
              Vector{1425312, 8788810, 70074185}};
  for (Vector& row : m) {
    const double sum = row[0] + row[1] + row[2];
    for (double& value : row) value /= sum;
  }
  return m;
}

constexpr Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

constexpr Matrix inverse(const Matrix& m) {
  const Vector columns[] = {cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1])};
  const double determinant = m[0][0] * columns[0][0] + m[0][1] * columns[0][1] + m[0][2] * columns[0][2];
  Matrix result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) result[i][j] = columns[j][i] / determinant;
  return result;
}

constexpr Matrix xyz_from_rgb = make_xyz_from_rgb();
constexpr Matrix rgb_from_xyz = inverse(xyz_from_rgb);

using Triple = std::array<float, 3>;

/// In floats; the matrix is known to the compiler.
inline Triple product(const Matrix& m, const Triple& v) {
  Triple result{};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = static_cast<float>(m[i][0]) * v[0] + static_cast<float>(m[i][1]) * v[1] +
                static_cast<float>(m[i][2]) * v[2];
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

/// The filters of both pipelines for one number of pixels a degree, each as its kernel along rows and the one
/// along columns.
struct Filters {
  using Kernel = image::Kernel<float>;
  // "Spatial filtering": the eye's contrast sensitivity to each opponent channel, as a sum of Gaussians
  // a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees. Blue-yellow has two, the others one.
  Kernel luminance, red_green;
  Kernel wide_rows, wide_columns, narrow_rows, narrow_columns;  ///< blue-yellow's two
  // "Feature detection": a Gaussian and its first and second derivative.
  Kernel smooth, slope, curvature;
  int radius = 0;  ///< the largest

  explicit Filters(double pixels_per_degree) {
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
    radius = std::max(color_radius, feature_radius);
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

/// A row of a picture behind all filters.
struct FilteredRow {
  std::vector<float> lightness, a, b;                   ///< the colour pipeline, as `hunt_lab`
  std::vector<float> edge_x, edge_y, point_x, point_y;  ///< the feature pipeline
};

/// By value: a reference, as std::clamp takes, would keep the loop below from becoming vector instructions.
inline float clamped(float v) {
  const float positive = v < 0 ? 0 : v;
  return positive > 1 ? 1 : positive;
}

/// Turns a row of filtered opponent channels into `hunt_lab`, as far as sRGB can show the colours.
void make_hunt_lab(std::size_t width, float* light, float* red_green, float* blue_yellow) {
  for (std::size_t x = 0; x < width; ++x) {
    const Triple rgb = product(rgb_from_xyz, {light[x] + red_green[x], light[x], light[x] - blue_yellow[x]});
    const Triple lab = hunt_lab({clamped(rgb[0]), clamped(rgb[1]), clamped(rgb[2])});
    light[x] = lab[0];
    red_green[x] = lab[1];
    blue_yellow[x] = lab[2];
  }
}

/// A picture filtered along its rows; `load` does the columns of one row. The opponent channels are y, x - y
/// and y - z of XYZ relative to white. The paper's are Y_y = 116 y - 16, c_x = 500 (x - y) and
/// c_z = 200 (y - z): the same to filters whose weights add up to 1.
class FilteredPicture {
 public:
  FilteredPicture(const Image8& picture, const Box& box, const Filters& filters) : filters_(filters) {
    Plane light(box.width(), box.height(), 1);
    Plane red_green = light, blue_yellow = light;
    std::array<float, 256> linear{};
    for (std::size_t i = 0; i < linear.size(); ++i) linear[i] = from_encoding8(static_cast<std::uint8_t>(i));
    const std::size_t green = picture.channels < 3 ? 0 : 1, blue = 2 * green;
    for (int y = 0; y < box.height(); ++y) {
      const std::uint8_t* rgb = &picture.at(box.left, box.bottom + y);
      for (int x = 0; x < box.width(); ++x, rgb += picture.channels) {
        const Triple xyz = product(xyz_from_rgb, {linear[rgb[0]], linear[rgb[green]], linear[rgb[blue]]});
        light.at(x, y) = xyz[1];
        red_green.at(x, y) = xyz[0] - xyz[1];
        blue_yellow.at(x, y) = xyz[1] - xyz[2];
      }
    }
    luminance_ = filtered_rows(light, filters.luminance);
    red_green_ = filtered_rows(red_green, filters.red_green);
    wide_ = filtered_rows(blue_yellow, filters.wide_rows);
    narrow_ = filtered_rows(blue_yellow, filters.narrow_rows);
    smooth_ = filtered_rows(light, filters.smooth);
    slope_ = filtered_rows(light, filters.slope);
    curvature_ = filtered_rows(light, filters.curvature);
  }

  void load(int y, FilteredRow& row) const {
    const auto filter = [&](const Plane& plane, const Filters::Kernel& kernel, std::vector<float>& out) {
      out.assign(static_cast<std::size_t>(plane.width), 0);
      add_filtered_column_row(plane, kernel, y, out.data());
    };
    filter(luminance_, filters_.luminance, row.lightness);
    filter(red_green_, filters_.red_green, row.a);
    filter(wide_, filters_.wide_columns, row.b);
    add_filtered_column_row(narrow_, filters_.narrow_columns, y, row.b.data());
    make_hunt_lab(row.b.size(), row.lightness.data(), row.a.data(), row.b.data());
    filter(slope_, filters_.smooth, row.edge_x);
    filter(smooth_, filters_.slope, row.edge_y);
    filter(curvature_, filters_.smooth, row.point_x);
    filter(smooth_, filters_.curvature, row.point_y);
  }

 private:
  const Filters& filters_;
  Plane luminance_, red_green_, wide_, narrow_, smooth_, slope_, curvature_;
};

// ---- Both ----

/// How much more of an edge or of a point the one picture has, 0 to 1 ("Feature metric").
float feature_error(const FilteredRow& a, const FilteredRow& b, std::size_t x) {
  const auto length = [](float u, float v) { return std::sqrt(u * u + v * v); };
  const float edges = length(a.edge_x[x], a.edge_y[x]) - length(b.edge_x[x], b.edge_y[x]);
  const float points = length(a.point_x[x], a.point_y[x]) - length(b.point_x[x], b.point_y[x]);
  // Raised to q_f = 1/2.
  return std::sqrt(std::max(std::abs(edges), std::abs(points)) / std::numbers::sqrt2_v<float>);
}

/// "Final difference": features raise the colours' error. The first loop becomes vector instructions.
void combine(const FilteredRow& a, const FilteredRow& b, std::vector<float>& distances,
             std::vector<float>& exponents, float* errors) {
  for (std::size_t x = 0; x < distances.size(); ++x) {
    distances[x] = hyab({a.lightness[x], a.a[x], a.b[x]}, {b.lightness[x], b.a[x], b.b[x]});
    exponents[x] = 1 - feature_error(a, b, x);
  }
  for (std::size_t x = 0; x < distances.size(); ++x)  // the power of 0, without its cost
    errors[x] = distances[x] == 0 ? 0 : std::pow(color_error(distances[x]), exponents[x]);
}

// ---- Pooling ----

/// The smallest of the errors, sorted upwards, up to which they add up to `share` of their sum; 0 of none.
double weighted_percentile(const std::vector<float>& sorted, double sum, double share) {
  double reached = 0;
  for (const float error : sorted) {
    reached += static_cast<double>(error);
    if (reached >= share * sum) return static_cast<double>(error);
  }
  return 0;
}

/// Colours 0, 16, 32, ..., 256 of the magma map's 256, sRGB-encoded; between them it is straight to 2 steps.
constexpr std::uint8_t magma[][3] = {
    {0, 0, 4},      {10, 8, 34},     {29, 17, 71},    {54, 16, 107},   {81, 18, 124},  {106, 28, 129},
    {131, 38, 129}, {156, 46, 127},  {183, 55, 121},  {208, 65, 111},  {231, 82, 99},  {245, 107, 92},
    {252, 137, 97}, {254, 167, 114}, {254, 196, 136}, {253, 226, 163}, {252, 255, 193}};

}  // namespace

ImageF flip_errors(const Image8& reference, const Image8& image, double pixels_per_degree) {
  check_sizes(reference, image, nullptr);
  check_any(!reference.samples.empty());
  if (!(pixels_per_degree >= 1 && pixels_per_degree <= 1000))
    throw Error::usage(fmt::format("FLIP does not work with {} pixels per degree", pixels_per_degree),
                       "give 1 to 1000");
  const Filters filters(pixels_per_degree);
  const Box box = box_to_compare(reference, image, filters.radius);  // beyond it the error is 0
  const FilteredPicture a(reference, box, filters), b(image, box, filters);
  ImageF errors(reference.width, reference.height, 1);
  const auto width = static_cast<std::size_t>(box.width());
  std::vector<float> distances(width), exponents(width);
  FilteredRow row_a, row_b;
  for (int y = 0; y < box.height(); ++y) {
    a.load(y, row_a);
    b.load(y, row_b);
    combine(row_a, row_b, distances, exponents, &errors.at(box.left, box.bottom + y));
  }
  return errors;
}

FlipFigures flip_figures(const ImageF& errors, const Image8* mask) {
  check_sizes(errors, errors, mask);
  std::vector<float> sorted;  // those above 0: in most pictures few
  std::size_t pixels = 0;
  for (int y = 0; y < errors.height; ++y)
    for (int x = 0; x < errors.width; ++x) {
      if (!counts(mask, x, y)) continue;
      ++pixels;
      if (errors.at(x, y) > 0) sorted.push_back(errors.at(x, y));
    }
  check_any(pixels > 0);
  std::sort(sorted.begin(), sorted.end());
  const double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
  const std::size_t zeros = pixels - sorted.size(), p99 = index_of_per_mille(pixels, 990);
  FlipFigures figures;
  figures.mean = sum / static_cast<double>(pixels);
  figures.p99 = p99 < zeros ? 0 : static_cast<double>(sorted[p99 - zeros]);
  figures.first_quartile = weighted_percentile(sorted, sum, 0.25);
  figures.median = weighted_percentile(sorted, sum, 0.5);
  figures.third_quartile = weighted_percentile(sorted, sum, 0.75);
  return figures;
}

Image8 flip_heatmap(const ImageF& errors, const Image8* mask) {
  check_sizes(errors, errors, mask);
  Image8 result(errors.width, errors.height, 3);
  for (int y = 0; y < errors.height; ++y)
    for (int x = 0; x < errors.width; ++x) {
      const double error = counts(mask, x, y) ? static_cast<double>(errors.at(x, y)) : 0;
      const double place = std::clamp(error, 0.0, 1.0) * 255 / 16;
      const auto below = static_cast<std::size_t>(place);
      for (std::size_t c = 0; c < 3; ++c) {
        const double value =
            std::lerp(magma[below][c], magma[below + 1][c], place - static_cast<double>(below));
        result.at(x, y, static_cast<int>(c)) = static_cast<std::uint8_t>(value + 0.5);
      }
    }
  return result;
}

}  // namespace texel::image
