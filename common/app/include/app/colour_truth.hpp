// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "app/truth_scene.hpp"
#include "image/colour.hpp"

namespace texel::app {

/// What a place of the picture shows: linear-light RGB and alpha 1, or zero beside the object.
using ColourAt = std::function<glm::dvec4(glm::dvec2 window)>;

/// The colour that a pixel should have: the mean of the object's light over the pixel (a box filter), in
/// steps of the 8-bit picture, sRGB-encoded and not rounded. Nothing where the pixel's middle misses the
/// object.
///
/// A few samples are enough where the picture is smooth, and a hundred are slow everywhere. So 8 are taken,
/// and 32 or 128 where the means of the earlier and of the later half differ by two steps or more.
inline std::optional<glm::dvec3> mean_in_steps(const ColourAt& colour, glm::dvec2 middle) {
  const glm::dvec4 in_the_middle = colour(middle);
  if (in_the_middle.a == 0) return std::nullopt;
  const auto steps = [](glm::dvec4 sum) {  // alpha counts the samples that met the object
    const glm::dvec3 mean = glm::dvec3(sum) / sum.a;
    return 255.0 * glm::dvec3(image::srgb_from_linear(mean.r), image::srgb_from_linear(mean.g),
                              image::srgb_from_linear(mean.b));
  };
  for (std::uint32_t count = 8;; count *= 4) {
    glm::dvec4 earlier(0), later(0);
    for (std::uint32_t i = 0; i < count; ++i)
      (i < count / 2 ? earlier : later) += colour(middle + place_in_pixel(i, count));
    const glm::dvec4 all = earlier + later;
    if (count == 128)
      return steps(all.a > 0 ? all : in_the_middle);  // a corner's tip may lie between samples
    if (earlier.a == 0 || later.a == 0) continue;
    const glm::dvec3 apart = glm::abs(steps(earlier) - steps(later));
    if (std::max({apart.r, apart.g, apart.b}) < 2) return steps(all);
  }
}
/// The truth of a picture of such colours.
inline Truth mean_in_steps(ColourAt colour) {
  return [colour = std::move(colour)](glm::dvec2 middle) { return mean_in_steps(colour, middle); };
}

}  // namespace texel::app
