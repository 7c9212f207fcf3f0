// SPDX-License-Identifier: MIT
#include "image/data_view.hpp"

#include <algorithm>
#include <cmath>

namespace texel::image {
namespace {

std::uint8_t byte_of(float value) {
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
}

float fraction(float value) {
  return value - std::floor(value);
}

}  // namespace

Image8 shown(const ImageF& values, const std::string& view) {
  Image8 picture(values.width, values.height, 3);
  const auto pixels = values.samples.size() / static_cast<std::size_t>(values.channels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const auto sample = [&](std::size_t c) {
      const auto channels = static_cast<std::size_t>(values.channels);
      return c < channels ? values.samples[i * channels + c] : 0.0F;
    };
    const float x = sample(0), y = sample(1), z = sample(2);
    float r = 0.20F, g = 0.22F, b = 0.25F;
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z)) {
      r = b = 1;
      g = 0;
    } else if (x == 0 && y == 0 && z == 0) {
      // background
    } else if (view == "texcoord") {
      r = fraction(x);
      g = fraction(y);
      b = 0;
    } else if (view == "lod") {
      const float t = std::clamp(x / 9, 0.0F, 1.0F);
      r = 0.27F + t * (-0.35F + t * 1.06F);
      g = 0.02F + t * (1.15F - t * 0.27F);
      b = 0.33F + t * (0.98F - t * 1.20F);
    } else if (view == "depth") {
      r = g = b = 1 / (1 + 0.25F * x);
    } else if (view == "mask") {
      r = g = b = x;
    } else {
      r = 0.5F + 0.5F * x;
      g = 0.5F + 0.5F * y;
      b = 0.5F + 0.5F * z;
    }
    picture.samples[3 * i] = byte_of(r);
    picture.samples[3 * i + 1] = byte_of(g);
    picture.samples[3 * i + 2] = byte_of(b);
  }
  return picture;
}

}  // namespace texel::image
