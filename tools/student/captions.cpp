// SPDX-License-Identifier: MIT
#include "captions.hpp"

#include <fmt/format.h>
#include <stb/stb_easy_font.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/legend.hpp"

namespace texel::tools {
namespace {

using Color = std::array<std::uint8_t, 3>;

constexpr int kLeast = 384;                // rows of a picture
constexpr int kSize = 2;                   // a pixel of the font is so many here
constexpr int kLine = 28, kBaseline = 22;  // of the line below the pictures

void fill(image::Image8& picture, int left, int bottom, int right, int top, const Color& color) {
  for (int y = std::max(bottom, 0); y < std::min(top, kLine); ++y)
    for (int x = left; x < std::min(right, picture.width); ++x) std::ranges::copy(color, &picture.at(x, y));
}

/// Writes a text of ASCII into the line below the pictures, from a pixel on; the first pixel behind it.
int write(image::Image8& picture, int left, std::string text) {
  struct Corner {  // as stb_easy_font writes them
    float x, y, z;
    std::uint32_t color;
  };
  std::vector<Corner> corners(64 * text.size());  // a letter takes 17 in the mean
  const int quads = stb_easy_font_print(0, 0, text.data(), nullptr, corners.data(),
                                        static_cast<int>(corners.size() * sizeof(Corner)));
  const auto pixels = [](float value) { return static_cast<int>(std::lround(value)) * kSize; };
  for (std::size_t i = 0; i < static_cast<std::size_t>(quads); ++i) {
    const Corner &upper_left = corners[4 * i], &lower_right = corners[4 * i + 2];
    fill(picture, left + pixels(upper_left.x), kBaseline - pixels(lower_right.y),
         left + pixels(lower_right.x), kBaseline - pixels(upper_left.y), {235, 235, 235});
  }
  return left + stb_easy_font_width(text.data()) * kSize;
}

}  // namespace

image::Image8 with_captions(const image::Compared& pictures, course::Unit unit) {
  const app::Legend legend = app::error_legend(pictures.full_scale, unit);
  const int zoom = (kLeast - 1) / pictures.own.height + 1;  // cases are small
  const image::Image8 row = image::side_by_side({pictures.own, pictures.expected, pictures.heat_map}, zoom);
  image::Image8 all(row.width, kLine + row.height, 3);
  std::ranges::copy(row.samples, &all.at(0, kLine));
  const int next = (row.width - pictures.own.width * zoom) / 2;
  write(all, 8, "yours");
  write(all, next + 8, "expected");
  int x = write(all, 2 * next + 8, legend.ticks.front().second + " ");
  for (int i = 0; i < legend.picture.width; ++i, ++x) {
    Color color{};
    std::copy_n(&legend.picture.at(i, 0), 3, color.begin());
    fill(all, x, 8, x + 1, kBaseline, color);
  }
  write(all, x, fmt::format(" {} {}", legend.ticks.back().second, name_of(unit)));
  return all;
}

}  // namespace texel::tools
