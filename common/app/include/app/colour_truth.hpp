// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <optional>

#include "app/truth_picture.hpp"
#include "image/colour.hpp"

namespace texel::app {

/// What a place of the picture shows: linear-light RGB and alpha 1, or zero beside the object.
using ColourAt = std::function<glm::dvec4(glm::dvec2 window)>;

/// The colour that a pixel should have: the mean of the object's light over the pixel (a box filter), in
/// steps of the 8-bit picture, sRGB-encoded and not rounded. Nothing where the pixel's middle misses the
/// object.
///
/// A few samples are enough where the picture is smooth, and hundreds are slow everywhere. So the samples are
/// doubled, from 4 up to 256, until the new ones' mean is within two steps of the mean of those before: then
/// the mean of both is good to about half a step.
inline std::optional<glm::dvec3> mean_in_steps(const ColourAt& colour, glm::dvec2 middle) {
  const glm::dvec4 in_the_middle = colour(middle);
  if (in_the_middle.a == 0) return std::nullopt;
  const auto steps = [](glm::dvec4 sum) {  // alpha counts the samples that met the object
    const glm::dvec3 mean = glm::dvec3(sum) / sum.a;
    return 255.0 * glm::dvec3(image::srgb_from_linear(mean.r), image::srgb_from_linear(mean.g),
                              image::srgb_from_linear(mean.b));
  };
  constexpr std::uint32_t few = 4, most = 256;
  std::uint32_t taken = 0;
  const auto take_until = [&](std::uint32_t count) {
    glm::dvec4 sum(0);
    while (taken < count) sum += colour(middle + place_in_pixel(taken++) + 0.5 / most);
    return sum;
  };
  glm::dvec4 all = take_until(few);
  while (taken < most) {
    const glm::dvec4 before = all, more = take_until(2 * taken);
    all += more;
    if (before.a == 0 || more.a == 0) continue;
    const glm::dvec3 apart = glm::abs(steps(before) - steps(more));
    if (std::max({apart.r, apart.g, apart.b}) < 2) break;
  }
  return steps(all.a > 0 ? all : in_the_middle);  // the tip of a corner may lie between the samples
}

}  // namespace texel::app
