// SPDX-License-Identifier: MIT
#include "gif.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/files.hpp"

namespace texel::assets {

namespace {

using Pixel = std::array<int, 3>;

/// Splits a box of colours at the median of the channel in which they differ most, `depth` times over, and
/// adds the mean of each part to the palette.
void median_cut(std::span<Pixel> box, int depth, std::vector<Pixel>& palette) {
  if (depth == 0) {
    Pixel mean{};
    for (std::size_t c = 0; c < 3; ++c) {
      for (const Pixel& pixel : box) mean[c] += pixel[c];
      mean[c] /= static_cast<int>(box.size());
    }
    return palette.push_back(mean);
  }
  std::pair<int, std::size_t> widest{-1, 0};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto [low, high] = std::ranges::minmax(box, {}, [c](const Pixel& pixel) { return pixel[c]; });
    widest = std::max(widest, {high[c] - low[c], c});
  }
  std::ranges::sort(box, {}, [c = widest.second](const Pixel& pixel) { return std::pair(pixel[c], pixel); });
  median_cut(box.first(box.size() / 2), depth - 1, palette);
  median_cut(box.subspan(box.size() / 2), depth - 1, palette);
}

int distance_squared(const Pixel& a, const Pixel& b) {
  const int r = a[0] - b[0], g = a[1] - b[1], bl = a[2] - b[2];
  return r * r + g * g + bl * bl;
}

}  // namespace

void save_gif(const std::filesystem::path& path, const image::Image8& picture) {
  std::vector<Pixel> pixels;
  for (int y = picture.height - 1; y >= 0; --y) {  // GIF's first row is the top one
    for (int x = 0; x < picture.width; ++x)
      pixels.push_back({picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)});
  }
  std::vector<Pixel> palette, sorted = pixels;
  median_cut(sorted, 8, palette);

  std::string bytes = "GIF89a";
  const auto byte = [&](int value) { bytes.push_back(static_cast<char>(value)); };
  const auto word = [&](int value) { byte(value & 0xff), byte(value >> 8); };
  word(picture.width), word(picture.height);
  byte(0xf7), byte(0), byte(0);  // a global palette of 256 colours
  for (const Pixel& pixel : palette) byte(pixel[0]), byte(pixel[1]), byte(pixel[2]);
  byte(','), word(0), word(0), word(picture.width), word(picture.height), byte(0);

  // LZW codes of 9 bits. A clear code every 250 pixels keeps the reader's table from growing to 10 bits.
  std::string codes;
  unsigned pending = 0, bits = 0;
  const auto code = [&](std::size_t value) {
    pending |= static_cast<unsigned>(value) << bits;
    for (bits += 9; bits >= 8; bits -= 8, pending >>= 8) codes.push_back(static_cast<char>(pending & 0xff));
  };
  constexpr std::size_t clear = 256, end = 257;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (i % 250 == 0) code(clear);
    const auto nearest = std::min_element(palette.begin(), palette.end(), [&](auto& a, auto& b) {
      return distance_squared(a, pixels[i]) < distance_squared(b, pixels[i]);
    });
    code(static_cast<std::size_t>(nearest - palette.begin()));
  }
  code(end);
  codes.push_back(static_cast<char>(pending));

  byte(8);
  for (std::size_t i = 0; i < codes.size(); i += 255) {  // in blocks of at most 255 bytes
    const std::string block = codes.substr(i, 255);
    byte(static_cast<int>(block.size())), bytes += block;
  }
  byte(0), byte(';');
  write_file(path, bytes);
}

}  // namespace texel::assets
