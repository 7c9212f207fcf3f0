// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>

#include "image/image.hpp"

namespace texel::image {

/// Linear light of an sRGB-encoded value, both 0..1, by the exact piecewise curve (IEC 61966-2-1); values
/// below 0 follow the straight part.
double linear_from_srgb(double encoded);
inline float linear_from_srgb(float encoded) {
  return static_cast<float>(linear_from_srgb(double{encoded}));
}

/// The inverse of `linear_from_srgb`.
double srgb_from_linear(double linear);
inline float srgb_from_linear(float linear) {
  return static_cast<float>(srgb_from_linear(double{linear}));
}

/// The linear value 0..1 of an 8-bit sample, from a table.
float from_encoding8(std::uint8_t sample, Encoding encoding = Encoding::srgb);

/// The 8-bit sample of a linear value: encoded, clamped to 0..255 and rounded to nearest, half up; NaN gives
/// 0. The inverse of `from_encoding8` for all 256 samples.
std::uint8_t to_encoding8(float linear, Encoding encoding = Encoding::srgb);

/// A heat map, sRGB-encoded R, G and B in 0..1: near black at t = 0 over violet, red and orange to pale
/// yellow at t = 1, clamped outside. Lightness grows evenly: equal distances in t are equal in OKLab
/// (B. Ottosson, "A perceptual color space for image processing", 2020). NaN gives pure green, which no other
/// t gives.
std::array<float, 3> heat(float t);

}  // namespace texel::image
