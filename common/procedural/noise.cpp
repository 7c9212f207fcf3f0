// SPDX-License-Identifier: MIT
#include "procedural/noise.hpp"

namespace texel::procedural {

namespace {

/// Every bit of the result depends on every bit of the argument (the finaliser of MurmurHash3).
std::uint32_t mix_bits(std::uint32_t h) {
  h ^= h >> 16;
  h *= 0x85ebca6bu;
  h ^= h >> 13;
  h *= 0xc2b2ae35u;
  return h ^ (h >> 16);
}

std::uint32_t hash(int x, int y, int z, std::uint32_t seed) {
  return mix_bits(seed * 0x9e3779b9u + static_cast<std::uint32_t>(x) * 0x8da6b343u +
                  static_cast<std::uint32_t>(y) * 0xd8163841u + static_cast<std::uint32_t>(z) * 0xcb1ab31fu);
}

/// As std::floor, which is a call of a function on machines without its instruction.
int floor_of(double a) {
  const int towards_zero = static_cast<int>(a);
  return towards_zero - (a < towards_zero ? 1 : 0);
}

}  // namespace

std::uint32_t hash(int x, int y, std::uint32_t seed) {
  const std::uint32_t h = mix_bits(seed * 0x9e3779b9u + static_cast<std::uint32_t>(x));
  return mix_bits(h * 0x9e3779b9u + static_cast<std::uint32_t>(y));
}

double noise(glm::dvec3 p, std::uint32_t seed) {
  const int i = floor_of(p.x), j = floor_of(p.y), k = floor_of(p.z);
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
