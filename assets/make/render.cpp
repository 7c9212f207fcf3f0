// SPDX-License-Identifier: MIT
#include "render.hpp"

#include <algorithm>
#include <glm/vec3.hpp>

#include "core/parallel.hpp"
#include "image/colour.hpp"

namespace texel::assets {

namespace {

std::uint8_t encode(double linear) {
  return static_cast<std::uint8_t>(255 * image::srgb_from_linear(std::clamp(linear, 0.0, 1.0)) + 0.5);
}

}  // namespace

void for_each_row(int height, const std::function<void(int y)>& row) {
  in_parallel(processors(), static_cast<std::size_t>(height),
              [&](std::size_t y) { row(static_cast<int>(y)); });
}

image::Image8 render(int width, int height, int channels, int samples, const Colour& colour) {
  image::Image8 picture(width, height, channels);
  const bool has_alpha = channels % 2 == 0;
  for_each_row(height, [&](int y) {
    for (int x = 0; x < width; ++x) {
      glm::dvec4 sum(0);  // colour times alpha, and alpha
      for (int j = 0; j < samples; ++j) {
        for (int i = 0; i < samples; ++i) {
          const glm::dvec4 c = colour((x + (i + 0.5) / samples) / width, (y + (j + 0.5) / samples) / height);
          sum += glm::dvec4(c.r * c.a, c.g * c.a, c.b * c.a, c.a);
        }
      }
      const glm::dvec3 mean = sum.a > 0 ? glm::dvec3(sum) / sum.a : glm::dvec3(0);
      if (channels <= 2) {
        picture.at(x, y) = encode((mean.r + mean.g + mean.b) / 3);
      } else {
        for (int c = 0; c < 3; ++c) picture.at(x, y, c) = encode(mean[c]);
      }
      if (has_alpha) {
        picture.at(x, y, channels - 1) = static_cast<std::uint8_t>(255 * sum.a / (samples * samples) + 0.5);
      }
    }
  });
  return picture;
}

}  // namespace texel::assets
