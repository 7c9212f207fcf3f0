// SPDX-License-Identifier: MIT
#include "truth/texture.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace texel::truth {

using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

double level_of_detail(const TexcoordGradient& gradient, dvec2 size) {
  return std::log2(std::max(glm::length(gradient.dx * size), glm::length(gradient.dy * size)));
}

namespace {

constexpr int kCells = 512;  // of a period, in each direction

/// Twice the signed area.
double area2(const std::array<dvec2, 4>& corners) {
  const dvec2 a = corners[2] - corners[0], b = corners[3] - corners[1];
  return a.x * b.y - a.y * b.x;
}

}  // namespace

void RepeatedTexture::prepare() const {
  sums_.resize(kCells * (kCells + 1));
  for (int row = 0; row < kCells; ++row)
    for (int cell = 0; cell < kCells; ++cell) {
      dvec4 sum(0);
      for (const double t : {0.25, 0.75})
        for (const double s : {0.25, 0.75}) sum += texture_(dvec2(cell + s, row + t) * (period_ / kCells));
      const auto here = static_cast<std::size_t>(row * (kCells + 1) + cell);
      sums_[here + 1] = sums_[here] + sum / 4.0;
    }
}

std::optional<dvec4> RepeatedTexture::mean(std::array<dvec2, 4> corners) const {
  for (dvec2& corner : corners) corner *= kCells / period_;  // now a cell is 1 x 1
  if (std::abs(area2(corners)) / 2 < kCells * kCells / 64.0) return std::nullopt;
  std::call_once(is_prepared_, [&] { prepare(); });

  // The integral from 0 to s in a row of cells.
  const auto integral = [&](int row, double s) {
    const double periods = std::floor(s / kCells), within = s - periods * kCells;
    const auto* sums = &sums_[static_cast<std::size_t>(row) * (kCells + 1)];
    const auto cell = std::min(static_cast<std::size_t>(within), std::size_t{kCells - 1});
    return periods * sums[kCells] + glm::mix(sums[cell], sums[cell + 1], within - static_cast<double>(cell));
  };
  const auto [low, high] = std::minmax({corners[0].y, corners[1].y, corners[2].y, corners[3].y});
  dvec4 sum(0);
  double area = 0;
  for (double row = std::floor(low); row < high; ++row) {
    const double from = std::max(row, low), to = std::min(row + 1, high), t = (from + to) / 2;
    double left = INFINITY, right = -INFINITY;  // where the row's middle line enters and leaves
    for (std::size_t i = 0; i < 4; ++i) {
      const dvec2 a = corners[i], b = corners[(i + 1) % 4];
      if ((a.y <= t) == (b.y <= t)) continue;
      const double s = a.x + (t - a.y) / (b.y - a.y) * (b.x - a.x);
      left = std::min(left, s), right = std::max(right, s);
    }
    if (!(left < right)) continue;
    const int within = static_cast<int>(row - kCells * std::floor(row / kCells));
    sum += (to - from) * (integral(within, right) - integral(within, left));
    area += (to - from) * (right - left);
  }
  return sum / area;
}

dvec4 QuadPicture::operator()(dvec2 window) const {
  const auto hit = hit_quad(object_ray(ray_through(camera, window), world_from_object));
  return hit ? texture(texcoord_map.texcoord(hit->texcoord)) : dvec4(0);
}

std::optional<dvec4> QuadPicture::mean(const RepeatedTexture& repeated, dvec2 middle) const {
  std::array<dvec2, 4> corners;
  constexpr dvec2 around[] = {{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto hit = hit_quad(object_ray(ray_through(camera, middle + around[i]), world_from_object));
    if (!hit) return std::nullopt;
    corners[i] = texcoord_map.texcoord(hit->texcoord);
  }
  return repeated.mean(corners);
}

Placement tilted(double degrees) {
  const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
  return {.linear = {dvec3(1, 0, 0), dvec3(0, c, -s), dvec3(0, s, c)}};
}

}  // namespace texel::truth
