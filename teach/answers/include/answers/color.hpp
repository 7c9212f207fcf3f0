// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

#include "answers/camera.hpp"
#include "image/color.hpp"
#include "procedural/cube_maps.hpp"
#include "procedural/textures.hpp"
#include "truth/texture.hpp"

namespace texel::answers {

/// The function of one of the bundled pictures; nothing for other files.
inline std::optional<procedural::Texture> texture_of(const std::string& name) {
  if (name == "brick_32" || name == "brick_128") return procedural::Texture::brick;
  if (name == "label_npot") return procedural::Texture::label_grid;
  for (const procedural::Texture texture : procedural::textures)
    if (procedural::name(texture) == name) return texture;
  return std::nullopt;
}

/// Linear light in a direction of any length.
using ColorOf = std::function<glm::dvec3(glm::dvec3 direction)>;

/// The function of one of the bundled cube maps; empty for the landscape and for other files: their formulas
/// are not known.
inline ColorOf cube_map_color(const std::string& name) {
  if (name == "labelled") return procedural::labelled_color;
  if (name == "smooth" || name == "smooth_5") return procedural::smooth_color;
  return {};
}

/// The colour at a place of the picture: linear-light RGB and alpha 1, or zero beside the object.
using ColorAt = std::function<glm::dvec4(glm::dvec2 window)>;

/// Linear light as levels of the 8-bit picture, sRGB-encoded and not rounded; above 1 it is clipped.
inline glm::dvec3 steps(glm::dvec3 light) {
  const glm::dvec3 clipped = glm::min(light, 1.0);
  return 255.0 * glm::dvec3(image::srgb_from_linear(clipped.r), image::srgb_from_linear(clipped.g),
                            image::srgb_from_linear(clipped.b));
}

/// The colour that a pixel should have: the mean of the object's light over the pixel (a box filter), in
/// levels of the 8-bit picture, sRGB-encoded and not rounded; light above 1 is clipped after the mean.
/// Nothing where the pixel's middle misses the object.
///
/// A few samples are enough where the picture is smooth, and thousands are slow everywhere. So 16 are taken,
/// and four times as many, up to 4,096, where the means of the earlier and of the later half differ by a
/// level or more, or two samples by so much that the halves may agree by chance. truth_error() says how far
/// off that is.
inline std::optional<glm::dvec3> mean_in_steps(const ColorAt& color, glm::dvec2 middle) {
  constexpr double agree = 1, chance = 24;  // levels
  const glm::dvec4 in_the_middle = color(middle);
  if (in_the_middle.a == 0) return std::nullopt;
  const auto apart = [&](glm::dvec3 a, glm::dvec3 b) {
    const glm::dvec3 difference = glm::abs(steps(a) - steps(b));
    return std::max({difference.r, difference.g, difference.b});
  };
  const auto mean = [](glm::dvec4 sum) { return glm::dvec3(sum) / sum.a; };  // of what met the object
  for (std::uint32_t count = 16;; count *= 4) {
    glm::dvec4 earlier(0), later(0);
    glm::dvec3 least(in_the_middle), greatest(in_the_middle);
    for (std::uint32_t i = 0; i < count; ++i) {
      const glm::dvec4 sample = color(middle + place_in_pixel(i, count));
      (i < count / 2 ? earlier : later) += sample;
      if (sample.a == 0) continue;
      least = glm::min(least, glm::dvec3(sample));
      greatest = glm::max(greatest, glm::dvec3(sample));
    }
    const bool agreed = earlier.a > 0 && later.a > 0 && apart(mean(earlier), mean(later)) < agree;
    if (count < 4096 && !(agreed && (count > 64 || apart(least, greatest) < chance))) continue;
    const glm::dvec4 all = earlier + later;
    return steps(mean(all.a > 0 ? all : in_the_middle));  // a corner's tip may lie between samples
  }
}

/// The truth of a square with a texture: `repeated` is the same texture, null if it does not repeat.
inline Truth mean_in_steps(truth::QuadPicture picture,
                           std::shared_ptr<const truth::RepeatedTexture> repeated) {
  return [picture = std::move(picture), repeated = std::move(repeated)](glm::dvec2 middle) {
    if (repeated)
      if (const auto mean = picture.mean(*repeated, middle)) return std::optional(steps(glm::dvec3(*mean)));
    return mean_in_steps([&](glm::dvec2 window) { return picture(window); }, middle);
  };
}

/// The truth of a picture of such colours.
inline Truth mean_in_steps(ColorAt color) {
  return [color = std::move(color)](glm::dvec2 middle) { return mean_in_steps(color, middle); };
}

}  // namespace texel::answers
