// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "image/colour.hpp"

namespace texel::app {

/// What a place of the picture shows: linear-light RGB and alpha 1, or zero beside the object.
using ColourAt = std::function<glm::dvec4(glm::dvec2 window)>;

/// The colour that a pixel should have: the mean of the object's light over the pixel (a box filter), in
/// steps of the 8-bit picture, sRGB-encoded and not rounded. Nothing where the pixel's middle misses the
/// object.
///
/// 16 samples are enough where the picture is smooth, and 256 are slow everywhere. So the samples are taken
/// apart like the fields of a chess board: where the black ones' mean and the white ones' differ by more than
/// half a step, four times as many are taken, up to 16 x 16.
inline std::optional<glm::dvec3> mean_in_steps(const ColourAt& colour, glm::dvec2 middle) {
  if (colour(middle).a == 0) return std::nullopt;
  const auto steps = [](glm::dvec4 premultiplied) {
    const glm::dvec3 mean = glm::dvec3(premultiplied) / premultiplied.a;
    return 255.0 * glm::dvec3(image::srgb_from_linear(mean.r), image::srgb_from_linear(mean.g),
                              image::srgb_from_linear(mean.b));
  };
  for (int n = 4;; n *= 2) {
    glm::dvec4 sum[2] = {glm::dvec4(0), glm::dvec4(0)};
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i)
        sum[(i + j) % 2] += colour(middle - 0.5 + (glm::dvec2(i, j) + 0.5) / static_cast<double>(n));
    const bool both = sum[0].a > 0 && sum[1].a > 0;
    if (both) {
      const glm::dvec3 apart = glm::abs(steps(sum[0]) - steps(sum[1]));
      if (n == 16 || std::max({apart.r, apart.g, apart.b}) < 0.5) return steps(sum[0] + sum[1]);
    } else if (n == 16) {
      return steps(colour(middle));  // a corner of the object, smaller than a sample's square
    }
  }
}

}  // namespace texel::app
