// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace texel::image {

/// A picture in memory: `channels` interleaved samples a pixel, rows tightly packed, **row 0 is the bottom
/// row** as in OpenGL's textures.
template <class Sample>
struct Image {
  int width = 0;     ///< pixels
  int height = 0;    ///< pixels
  int channels = 0;  ///< 1 to 4: grey, grey and alpha, RGB, RGBA
  std::vector<Sample> samples;

  Image() = default;
  Image(int width_, int height_, int channels_)
      : width(width_), height(height_), channels(channels_), samples(index(0, height_)) {}

  [[nodiscard]] std::size_t index(int x, int y, int channel = 0) const {
    return static_cast<std::size_t>((std::int64_t{y} * width + x) * channels + channel);
  }
  [[nodiscard]] Sample& at(int x, int y, int channel = 0) { return samples[index(x, y, channel)]; }
  [[nodiscard]] const Sample& at(int x, int y, int channel = 0) const {
    return samples[index(x, y, channel)];
  }

  bool operator==(const Image&) const = default;
};

using Image8 = Image<std::uint8_t>;  ///< 0..255, sRGB-encoded colour or linear data: the caller knows which
using ImageF = Image<float>;         ///< any value, linear

/// The same picture upside down.
template <class Sample>
Image<Sample> flipped(const Image<Sample>& image) {
  Image<Sample> result(image.width, image.height, image.channels);
  const auto row = static_cast<std::ptrdiff_t>(image.index(0, 1));
  for (std::ptrdiff_t y = 0; y < image.height; ++y)
    std::copy_n(image.samples.begin() + row * y, row, result.samples.begin() + row * (image.height - 1 - y));
  return result;
}

/// The same picture of three channels, from one of four.
template <class Sample>
Image<Sample> without_alpha(const Image<Sample>& rgba) {
  Image<Sample> rgb(rgba.width, rgba.height, 3);
  for (std::size_t i = 0; i < rgb.samples.size(); ++i) rgb.samples[i] = rgba.samples[i / 3 * 4 + i % 3];
  return rgb;
}

/// The square of `side` pixels around a pixel, `side` odd; 0 beyond the picture.
template <class Sample>
Image<Sample> square_around(const Image<Sample>& image, int x, int y, int side) {
  Image<Sample> square(side, side, image.channels);
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const int from_x = x + i - side / 2, from_y = y + j - side / 2;
      if (from_x < 0 || from_y < 0 || from_x >= image.width || from_y >= image.height) continue;
      for (int c = 0; c < image.channels; ++c) square.at(i, j, c) = image.at(from_x, from_y, c);
    }
  return square;
}

/// How the samples of a colour picture are to be read.
enum class Encoding {
  srgb,   ///< colour: R, G and B by the sRGB curve (IEC 61966-2-1), alpha linear
  linear  ///< data: normals, heights, masks
};

}  // namespace texel::image
