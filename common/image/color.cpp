// SPDX-License-Identifier: MIT
#include "image/color.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace texel::image {
namespace {

/// Finds the 8-bit sRGB sample of a linear value without the power function. A sample begins where the curve
/// passes half a step below it; the curve's steepest step is 1 / (255 * 12.92) wide, so that a cell of
/// 1 / 4096 holds at most one such beginning and one comparison settles the rest.
class SrgbRounding {
 public:
  SrgbRounding() {
    for (std::size_t i = 0; i < begins_.size(); ++i)
      begins_[i] = linear_from_srgb((static_cast<double>(i) - 0.5) / 255);
    std::size_t sample = 0;
    for (std::size_t cell = 0; cell <= cells; ++cell) {
      while (sample < 255 && begins_[sample + 1] <= static_cast<double>(cell) / cells) ++sample;
      at_cell_[cell] = static_cast<std::uint8_t>(sample);
    }
  }

  /// `linear` in 0..1.
  [[nodiscard]] std::uint8_t sample(float linear) const {
    const std::uint8_t low = at_cell_[static_cast<std::size_t>(linear * cells)];
    const bool next = low < 255 && static_cast<double>(linear) >= begins_[low + std::size_t{1}];
    return static_cast<std::uint8_t>(low + (next ? 1 : 0));
  }

 private:
  static constexpr std::size_t cells = 4096;
  std::array<double, 256> begins_{};
  std::array<std::uint8_t, cells + 1> at_cell_{};
};

using Triple = std::array<double, 3>;

/// Linear sRGB of an OKLab colour (B. Ottosson, 2020; https://bottosson.github.io/posts/oklab/).
Triple linear_from_oklab(const Triple& lab) {
  const auto cube = [](double v) { return v * v * v; };
  const double l = cube(lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2]);
  const double m = cube(lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2]);
  const double s = cube(lab[0] - 0.0894841775 * lab[1] - 1.2914855480 * lab[2]);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

/// The heat map's way through OKLab for s in 0..1: lightness grows, the hue turns from violet over red to
/// yellow, and the chroma stays just inside what sRGB can show.
Triple heat_path(double s) {
  const double lightness = std::lerp(0.12, 0.96, s);
  const double chroma = 0.183 * std::sin(std::numbers::pi * (0.1 + 0.79 * s));
  const double hue = std::lerp(285.0, 468.0, s) * std::numbers::pi / 180;
  return {lightness, chroma * std::cos(hue), chroma * std::sin(hue)};
}

using HeatTable = std::array<std::array<float, 3>, 257>;

/// The path sampled at equal distances in OKLab.
HeatTable make_heat_table() {
  constexpr std::size_t pieces = 1024;
  std::array<double, pieces + 1> length{};
  Triple before = heat_path(0);
  for (std::size_t i = 1; i <= pieces; ++i) {
    const Triple here = heat_path(static_cast<double>(i) / pieces);
    length[i] = length[i - 1] + std::hypot(here[0] - before[0], here[1] - before[1], here[2] - before[2]);
    before = here;
  }
  HeatTable table{};
  std::size_t piece = 1;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double wanted = length[pieces] * static_cast<double>(i) / static_cast<double>(table.size() - 1);
    while (piece < pieces && length[piece] < wanted) ++piece;
    const double beyond = (length[piece] - wanted) / (length[piece] - length[piece - 1]);
    const Triple linear = linear_from_oklab(heat_path((static_cast<double>(piece) - beyond) / pieces));
    for (std::size_t c = 0; c < 3; ++c)
      table[i][c] = static_cast<float>(srgb_from_linear(std::clamp(linear[c], 0.0, 1.0)));
  }
  return table;
}

}  // namespace

double linear_from_srgb(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double srgb_from_linear(double linear) {
  return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

float from_encoding8(std::uint8_t sample, Encoding encoding) {
  static const auto linear_values = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<float>(linear_from_srgb(static_cast<double>(i) / 255));
    return values;
  }();
  return encoding == Encoding::srgb ? linear_values[sample] : static_cast<float>(sample) / 255.0F;
}

std::uint8_t to_encoding8(float linear, Encoding encoding) {
  static const SrgbRounding rounding;
  if (!(linear > 0)) return 0;  // NaN too
  if (linear >= 1) return 255;
  return encoding == Encoding::srgb ? rounding.sample(linear)
                                    : static_cast<std::uint8_t>(static_cast<double>(linear) * 255 + 0.5);
}

std::array<float, 3> heat(float t) {
  static const HeatTable table = make_heat_table();
  if (std::isnan(t)) return {0, 1, 0};
  const float place = std::clamp(t, 0.0F, 1.0F) * static_cast<float>(table.size() - 1);
  const std::size_t low = std::min(static_cast<std::size_t>(place), table.size() - 2);
  std::array<float, 3> color{};
  for (std::size_t c = 0; c < 3; ++c)
    color[c] = std::lerp(table[low][c], table[low + 1][c], place - static_cast<float>(low));
  return color;
}

}  // namespace texel::image
