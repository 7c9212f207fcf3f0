// SPDX-License-Identifier: MIT
#include "image/compared.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>

#include "core/error.hpp"

namespace texel::image {
namespace {

glm::vec3 color_of(const glm::vec3& value, const std::string& view) {
  if (!std::isfinite(value.x) || !std::isfinite(value.y) || !std::isfinite(value.z)) return {1, 0, 1};
  if (value == glm::vec3(0)) return {0.20F, 0.22F, 0.25F};
  if (view == "texcoord") return {glm::fract(value.x), glm::fract(value.y), 0};
  if (view == "depth") return glm::vec3(1 / (1 + 0.25F * value.x));
  if (view == "mask") return glm::vec3(value.x);
  if (view != "lod") return 0.5F + 0.5F * value;
  const float t = std::clamp(value.x / 9, 0.0F, 1.0F);
  return {0.27F + t * (-0.35F + t * 1.06F), 0.02F + t * (1.15F - t * 0.27F), 0.33F + t * (0.98F - t * 1.20F)};
}

/// `shown` makes of a picture what one looks at.
template <class Picture, class Shown>
Compared compared(const Picture& own, const Picture& expected, double least_scale, const Comparing& comparing,
                  const Shown& shown) {
  if (own.width != expected.width || own.height != expected.height)
    throw Error::failed("your picture does not have the size of the expected one");
  Compared all{shown(own), shown(expected), {}, compare(expected, own, comparing), 0};
  all.full_scale = std::max(std::isnan(comparing.told) ? all.figures.max : comparing.told, least_scale);
  all.heat_map = heatmap(all.figures, all.full_scale);
  return all;
}

}  // namespace

Image8 shown(const ImageF& values, const std::string& view) {
  Image8 picture(values.width, values.height, 3);
  for (int y = 0; y < values.height; ++y)
    for (int x = 0; x < values.width; ++x) {
      glm::vec3 value(0);
      for (int c = 0; c < std::min(values.channels, 3); ++c) value[c] = values.at(x, y, c);
      const glm::vec3 color = color_of(value, view);
      for (int c = 0; c < 3; ++c)
        picture.at(x, y, c) = static_cast<std::uint8_t>(std::lround(255 * std::clamp(color[c], 0.0F, 1.0F)));
    }
  return picture;
}

Compared compared(const Image8& own, const Image8& expected, double least_scale, double error) {
  return compared(own, expected, least_scale, {.told = error}, std::identity());
}

Compared compared(const ImageF& own, const ImageF& expected, double least_scale, double error,
                  const std::string& view, bool in_degrees) {
  return compared(own, expected, least_scale, {.in_degrees = in_degrees, .told = error},
                  [&](const ImageF& values) { return shown(values, view); });
}

Image8 side_by_side(const std::vector<Image8>& pictures, int zoom) {
  constexpr int kGap = 6;
  const int width = pictures.front().width * zoom, count = static_cast<int>(pictures.size());
  Image8 all(count * width + (count - 1) * kGap, pictures.front().height * zoom, 3);
  std::fill(all.samples.begin(), all.samples.end(), std::uint8_t{128});
  for (int i = 0; i < count; ++i)
    for (int y = 0; y < all.height; ++y)
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < 3; ++c)
          all.at(i * (width + kGap) + x, y, c) =
              pictures[static_cast<std::size_t>(i)].at(x / zoom, y / zoom, c);
  return all;
}

}  // namespace texel::image
