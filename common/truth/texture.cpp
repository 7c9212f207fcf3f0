// SPDX-License-Identifier: MIT
#include "truth/texture.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

namespace texel::truth {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

namespace {

/// The texel that stands at index i of an endless row.
int wrapped(double i, int size, Wrap wrap) {
  const double n = size;
  if (wrap == Wrap::clamp) return static_cast<int>(std::clamp(i, 0.0, n - 1));
  const double period = wrap == Wrap::repeat ? n : 2 * n;
  const double within = i - period * std::floor(i / period);
  return static_cast<int>(within < n ? within : 2 * n - 1 - within);
}

/// The integral from 0 to x of the wave that is +1 on [0, 1), -1 on [1, 2) and so on: a triangle wave.
double square_wave_integral(double x) {
  return 1 - std::abs(x - 2 * std::floor(0.5 * x) - 1);
}

}  // namespace

TextureFunction texture_function(procedural::Texture texture) {
  return [texture](dvec2 texcoord) { return procedural::colour(texture, texcoord.s, texcoord.t); };
}

Bitmap sampled(const TextureFunction& function, int width, int height) {
  Bitmap bitmap{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      bitmap.texels.push_back(function(dvec2(x + 0.5, y + 0.5) / dvec2(width, height)));
  return bitmap;
}

dvec4 nearest(const Bitmap& bitmap, dvec2 texcoord, Wrap wrap) {
  const dvec2 texel = glm::floor(texcoord * dvec2(bitmap.width, bitmap.height));
  return bitmap.at(wrapped(texel.x, bitmap.width, wrap), wrapped(texel.y, bitmap.height, wrap));
}

dvec4 bilinear(const Bitmap& bitmap, dvec2 texcoord, Wrap wrap) {
  // Texels hold the colour of their middle, half a texel from their corner.
  const dvec2 place = texcoord * dvec2(bitmap.width, bitmap.height) - 0.5;
  const dvec2 low = glm::floor(place), weight = place - low;
  const int x0 = wrapped(low.x, bitmap.width, wrap), x1 = wrapped(low.x + 1, bitmap.width, wrap);
  const int y0 = wrapped(low.y, bitmap.height, wrap), y1 = wrapped(low.y + 1, bitmap.height, wrap);
  return glm::mix(glm::mix(bitmap.at(x0, y0), bitmap.at(x1, y0), weight.x),
                  glm::mix(bitmap.at(x0, y1), bitmap.at(x1, y1), weight.x), weight.y);
}

double level_of_detail(const TexcoordGradient& gradient, dvec2 size) {
  return std::log2(std::max(glm::length(gradient.dx * size), glm::length(gradient.dy * size)));
}

dvec4 pixel_mean(const std::function<dvec4(dvec2)>& colour, dvec2 corner, int n) {
  dvec4 sum(0);
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) sum += colour(corner + dvec2(i + 0.5, j + 0.5) / static_cast<double>(n));
  return sum / (static_cast<double>(n) * n);
}

dvec4 QuadPicture::at(dvec2 window) const {
  const auto hit = hit_quad(object_ray(pixel_ray(camera, window).ray, world_from_object), half_size);
  return hit ? texture(texcoord_map.texcoord(hit->texcoord)) : background;
}

dvec4 QuadPicture::pixel(int x, int y, int n) const {
  return pixel_mean([this](dvec2 window) { return at(window); }, dvec2(x, y), n);
}

Placement tilted(double degrees) {
  const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
  return {.linear = {dvec3(1, 0, 0), dvec3(0, c, -s), dvec3(0, s, c)}};
}

double checker_mean(dvec2 low, dvec2 high) {
  constexpr double fields = 8;
  const auto mean = [](double from, double to) {
    return (square_wave_integral(fields * to) - square_wave_integral(fields * from)) / (fields * (to - from));
  };
  return 0.5 - 0.5 * mean(low.s, high.s) * mean(low.t, high.t);
}

}  // namespace texel::truth
