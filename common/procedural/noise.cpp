// SPDX-License-Identifier: MIT
#include "procedural/noise.hpp"

namespace texel::procedural {

namespace {

std::uint32_t hash(int x, int y, int z, std::uint32_t seed) {
  return detail::mix_bits(seed * 0x9e3779b9u + static_cast<std::uint32_t>(x) * 0x8da6b343u +
                          static_cast<std::uint32_t>(y) * 0xd8163841u +
                          static_cast<std::uint32_t>(z) * 0xcb1ab31fu);
}

}  // namespace

double noise(glm::dvec3 p, std::uint32_t seed) {
  const int i = detail::floor_of(p.x), j = detail::floor_of(p.y), k = detail::floor_of(p.z);
  const double x = p.x - i, y = p.y - j, z = p.z - k;
  // Height, seen from a corner, of the linear function with that corner's random gradient.
  const auto corner = [&](int di, int dj, int dk) {
    const std::uint32_t bits = hash(i + di, j + dj, k + dk, seed);
    const auto component = [&](int shift) { return static_cast<int>(bits >> shift & 0x3ffu) - 512; };
    return component(0) * (x - di) + component(10) * (y - dj) + component(20) * (z - dk);
  };
  const double tx = smooth_step(0, 1, x), ty = smooth_step(0, 1, y), tz = smooth_step(0, 1, z);
  const auto layer = [&](int dk) {
    return mix(mix(corner(0, 0, dk), corner(1, 0, dk), tx), mix(corner(0, 1, dk), corner(1, 1, dk), tx), ty);
  };
  return 1.4 / 512 * mix(layer(0), layer(1), tz);
}

double fbm(glm::dvec3 p, int octaves, std::uint32_t seed) {
  double sum = 0, amplitude = 0.5;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += amplitude * noise(p, seed + static_cast<std::uint32_t>(octave));
    p *= 2.0;
    amplitude *= 0.5;
  }
  return sum;
}

}  // namespace texel::procedural
