// SPDX-License-Identifier: MIT
#include "terrain.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "procedural/noise.hpp"
#include "render.hpp"

namespace texel::assets {

namespace {

using glm::dvec3;
using procedural::smooth_step;

/// Sharp crests with ever finer ones on their flanks, 0 to about 1 (Musgrave's ridged multifractal).
double ridges(dvec3 p) {
  double sum = 0, amplitude = 0.5, weight = 1;
  for (std::uint32_t octave = 0; octave < 7; ++octave) {
    const double crest = std::max(0.0, 1 - 1.25 * std::abs(procedural::noise(p, 300 + octave)));
    const double height = crest * crest * weight;
    sum += amplitude * height;
    weight = std::clamp(1.6 * height, 0.0, 1.0);
    amplitude *= 0.5;
    p = 2.03 *
        dvec3(0.8 * p.x - 0.6 * p.z, p.y, 0.6 * p.x + 0.8 * p.z);  // turned, so that octaves do not line up
  }
  return sum;
}

double elevation(double x, double z) {
  const double r = std::hypot(x, z);
  if (r < 300) return 0;
  const double hills =
      smooth_step(300, 1100, r) * (70 + 90 * procedural::fbm(dvec3(x / 420, 0.5, z / 420), 5, 310));
  // Towards -z the range is high, elsewhere it is a far blue line.
  const double side = smooth_step(-0.5, 0.75, -z / r);
  const double range = smooth_step(1000, 3800, r) * (0.30 + 0.70 * side);
  return std::max(0.0, hills) + 1450 * range * std::pow(ridges(dvec3(x / 1900, 1.3, z / 1900)), 1.25);
}

}  // namespace

Terrain::Terrain() : heights_(std::size_t{size} * size) {
  for_each_row(size, [&](int j) {
    for (int i = 0; i < size; ++i) {
      heights_[static_cast<std::size_t>(j * size + i)] =
          static_cast<float>(elevation(i * cell - extent, j * cell - extent));
    }
  });
}

double Terrain::height(double x, double z) const {
  const double gx = (x + extent) / cell, gz = (z + extent) / cell;
  if (gx < 0 || gz < 0 || gx >= size - 1 || gz >= size - 1) return 0;
  const int i = static_cast<int>(gx), j = static_cast<int>(gz);
  const float* const row = &heights_[static_cast<std::size_t>(j * size + i)];
  const double tx = gx - i, tz = gz - j;
  return (row[0] * (1 - tx) + row[1] * tx) * (1 - tz) + (row[size] * (1 - tx) + row[size + 1] * tx) * tz;
}

glm::dvec3 Terrain::normal(double x, double z) const {
  return glm::normalize(
      dvec3(height(x - cell, z) - height(x + cell, z), 2 * cell, height(x, z - cell) - height(x, z + cell)));
}

double Terrain::intersect(glm::dvec3 origin, glm::dvec3 direction) const {
  constexpr double highest = 1900;
  double t = 260, before = t;
  while (t < 1.4 * extent) {
    const dvec3 p = origin + t * direction;
    if (p.y > highest && direction.y > 0) return -1;
    const double above = p.y - height(p.x, p.z);
    if (above < 0) {
      for (int halving = 0; halving < 10; ++halving) {
        const double middle = 0.5 * (before + t);
        const dvec3 q = origin + middle * direction;
        (q.y < height(q.x, q.z) ? t : before) = middle;
      }
      return t;
    }
    before = t;
    t += std::max(0.0015 * t, 0.35 * above);
  }
  return -1;
}

}  // namespace texel::assets
