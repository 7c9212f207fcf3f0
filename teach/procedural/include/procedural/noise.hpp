// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "procedural/dual.hpp"

namespace texel::procedural {

namespace detail {

/// Every bit of the result depends on every bit of the argument (the finaliser of MurmurHash3).
inline std::uint32_t mix_bits(std::uint32_t h) {
  h ^= h >> 16;
  h *= 0x85ebca6bU;
  h ^= h >> 13;
  h *= 0xc2b2ae35U;
  return h ^ (h >> 16);
}

/// As std::floor, which is a call of a function on machines without its instruction.
inline int floor_of(double a) {
  const int towards_zero = static_cast<int>(a);
  return towards_zero - (a < towards_zero ? 1 : 0);
}

}  // namespace detail

/// A well-mixed 32-bit number from a lattice point and a seed, the same on every machine.
inline std::uint32_t hash(int x, int y, std::uint32_t seed) {
  const std::uint32_t h = detail::mix_bits(seed * 0x9e3779b9U + static_cast<std::uint32_t>(x));
  return detail::mix_bits(h * 0x9e3779b9U + static_cast<std::uint32_t>(y));
}

/// The hash as a number in [0, 1).
inline double random(int x, int y, std::uint32_t seed) {
  return hash(x, y, seed) * 0x1p-32;
}

/// The remainder that is never negative: in [0, period).
inline int wrap(int i, int period) {
  const int rest = i % period;
  return rest < 0 ? rest + period : rest;
}

/// Gradient noise, about -0.9 to 0.9 and mostly within +-0.5, one feature a unit, twice differentiable,
/// repeating after (period_x, period_y) units. Real is double or Dual. Source: Perlin, Improving Noise
/// (2002).
template <class Real>
Real noise(Real x, Real y, int period_x, int period_y, std::uint32_t seed) {
  const int i = detail::floor_of(value(x)), j = detail::floor_of(value(y));
  const Real fx = x - static_cast<double>(i);
  const Real fy = y - static_cast<double>(j);
  const int i0 = wrap(i, period_x), i1 = i0 + 1 == period_x ? 0 : i0 + 1;
  const int j0 = wrap(j, period_y), j1 = j0 + 1 == period_y ? 0 : j0 + 1;
  const Real tx = smooth_step(0, 1, fx), ty = smooth_step(0, 1, fy);
  // Height at (x, y), seen from a lattice point, of the plane through that point with its random slope.
  const auto plane = [&](int i_at, int j_at, Real x_from, Real y_from) {
    const std::uint32_t bits = hash(i_at, j_at, seed);
    const double slope_x = (bits & 0xffffU) * 0x2p-16 - 1.0;
    const double slope_y = (bits >> 16) * 0x2p-16 - 1.0;
    return x_from * slope_x + y_from * slope_y;
  };
  const Real below = mix(plane(i0, j0, fx, fy), plane(i1, j0, fx - 1.0, fy), tx);
  const Real above = mix(plane(i0, j1, fx, fy - 1.0), plane(i1, j1, fx - 1.0, fy - 1.0), tx);
  return mix(below, above, ty);
}

/// Octaves of noise, each of half the size and half the height of the one before, repeating on the unit
/// square when the frequencies are whole (fractal Brownian motion). About -1 to 1, mostly within +-0.5.
template <class Real>
Real fbm(Real u, Real v, int frequency_u, int frequency_v, int octaves, std::uint32_t seed) {
  Real sum = 0.0;
  double amplitude = 1.0;
  for (int octave = 0; octave < octaves; ++octave) {
    const int fu = frequency_u << octave, fv = frequency_v << octave;
    sum = sum + amplitude * noise<Real>(u * static_cast<double>(fu), v * static_cast<double>(fv), fu, fv,
                                        seed + static_cast<std::uint32_t>(octave));
    amplitude *= 0.5;
  }
  return sum;
}

}  // namespace texel::procedural
