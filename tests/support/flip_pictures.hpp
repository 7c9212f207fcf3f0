// SPDX-License-Identifier: MIT
// Pictures to compare, made by formulas: the same everywhere.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "image/image.hpp"

namespace texel::image {

/// One channel, `value(x, y)` at each pixel.
template <class Value>
Image8 made(int width, int height, const Value& value) {
  Image8 picture(width, height, 1);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) picture.at(x, y) = static_cast<std::uint8_t>(value(x, y));
  return picture;
}

inline Image8 constant(int width, int height, std::array<std::uint8_t, 3> rgb) {
  Image8 picture(width, height, 3);
  for (std::size_t i = 0; i < picture.samples.size(); ++i) picture.samples[i] = rgb[i % 3];
  return picture;
}

/// A hash of a number, 0..255, the same everywhere.
inline int noise(unsigned n) {
  n = (n ^ 61U) ^ (n >> 16U);
  n *= 9U;
  n ^= n >> 4U;
  n *= 0x27d4eb2dU;
  n ^= n >> 15U;
  return static_cast<int>(n & 255U);
}

/// Soft colours, a disc with a hard edge, fine stripes on the right, dots at the top and some noise.
inline Image8 scene(int width, int height, int shift = 0) {
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

/// `change(sample, i)` for each sample i, cut to 0..255.
template <class Change>
Image8 changed(Image8 picture, const Change& change) {
  for (std::size_t i = 0; i < picture.samples.size(); ++i)
    picture.samples[i] = static_cast<std::uint8_t>(std::clamp<int>(change(picture.samples[i], i), 0, 255));
  return picture;
}

inline Image8 mirrored(const Image8& picture) {
  Image8 result(picture.width, picture.height, picture.channels);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      for (int c = 0; c < picture.channels; ++c) result.at(x, y, c) = picture.at(picture.width - 1 - x, y, c);
  return result;
}

/// Columns below `edge` black, the others white.
inline Image8 step(int width, int height, int edge) {
  return made(width, height, [=](int x, int) { return x < edge ? 0 : 255; });
}

}  // namespace texel::image
