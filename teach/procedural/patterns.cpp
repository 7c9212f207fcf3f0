// SPDX-License-Identifier: MIT
#include "procedural/patterns.hpp"

#include "procedural/noise.hpp"

namespace texel::procedural {

namespace {

template <class Real>
int floor_of(Real a) {
  return static_cast<int>(std::floor(value(a)));
}

/// Signed distance to a rectangle with rounded corners about the origin, negative inside. Its derivative is
/// continuous out to `radius` inside the edge; deeper inside, it is cut off at -radius.
template <class Real>
Real rounded_rectangle(Real x, Real y, double half_width, double half_height, double radius) {
  using std::abs, std::sqrt;
  const Real qx = abs(x) - (half_width - radius);
  const Real qy = abs(y) - (half_height - radius);
  if (value(qx) <= 0 && value(qy) <= 0) return -radius;
  if (value(qx) <= 0) return qy - radius;
  if (value(qy) <= 0) return qx - radius;
  return sqrt(qx * qx + qy * qy) - radius;
}

}  // namespace

template <class Real>
Brick<Real> brick_at(Real u, Real v) {
  constexpr int columns = 4, rows = 8;
  constexpr double joint = 0.0055;  // half of the mortar's width
  constexpr double bevel = 0.012;
  constexpr double wobble =
      0.006;  // edges are not straight; less than joint + bevel, so no brick meets another

  const Real x = u + wobble * fbm(u, v, 10, 10, 3, 11);
  const Real y = v + wobble * fbm(u, v, 10, 10, 3, 21);

  Brick<Real> brick;
  const int row = floor_of(y * rows);
  const Real along = x * columns - (row % 2 != 0 ? 0.5 : 0.0);
  const int column = floor_of(along);
  brick.row = wrap(row, rows);
  brick.column = wrap(column, columns);
  brick.x = (along - (column + 0.5)) / columns;
  brick.y = (y * rows - (row + 0.5)) / rows;
  const Real outside =
      rounded_rectangle(brick.x, brick.y, 0.5 / columns - joint, 0.5 / rows - joint, 1.4 * bevel);
  brick.inside = smooth_step(0, -bevel, outside);
  return brick;
}
template Brick<double> brick_at(double, double);
template Brick<Dual> brick_at(Dual, Dual);

Plank plank_at(double u, double v) {
  constexpr int rows = 6;
  constexpr double groove = 0.0025;  // half of its width
  constexpr double edge = 0.008;
  constexpr double ring_width = 0.0085;

  Plank plank;
  const int row = static_cast<int>(std::floor(v * rows));
  plank.row = wrap(row, rows);
  // Neighbouring ends are at least a quarter of a plank apart: a step of 0.38 each row.
  const Dual along = Dual::u(u) - (0.38 * plank.row + 0.1 * random(plank.row, 0, 31));
  const int column = floor_of(along);
  plank.x = along - (column + 0.5);
  plank.y = (Dual::v(v) * rows - (row + 0.5)) / rows;
  const Dual outside = rounded_rectangle(plank.x, plank.y, 0.5 - groove, 0.5 / rows - groove, edge);
  plank.inside = smooth_step(0, -edge, outside);

  // The board is cut from a trunk whose axis lies `depth` below it and a little oblique: rings become long
  // arches. A plank's noise need not repeat, since the plank ends in a groove; the big periods only say so.
  const auto own = [&](int which) { return random(plank.row, which, 32); };
  const auto seed = static_cast<std::uint32_t>(40 + 10 * plank.row);
  const Dual depth = 0.05 + 0.05 * own(1) + (own(2) < 0.5 ? -1.0 : 1.0) * (0.05 + 0.05 * own(3)) * plank.x +
                     0.012 * noise<Dual>(plank.x * 3.0, plank.y * 6.0, 64, 64, seed);
  const Dual across =
      plank.y - 0.05 * (own(4) - 0.5) + 0.010 * noise<Dual>(plank.x * 4.0, plank.y * 9.0, 64, 64, seed + 1);
  const Dual radius = sqrt(depth * depth + across * across);
  plank.ring = radius / ring_width + 0.35 * noise<Dual>(plank.x * 14.0, plank.y * 60.0, 256, 256, seed + 2);

  // A knot: rings close around where a branch grew out.
  if (own(5) < 0.6) {
    const Dual kx = (plank.x - 0.7 * (own(6) - 0.5)) / 0.030;
    const Dual ky = (plank.y - 0.07 * (own(7) - 0.5)) / 0.018;
    const Dual distance = kx * kx + ky * ky;
    plank.knot = exp(-1.2 * distance);
    plank.ring = plank.ring + 5.0 * exp(-0.35 * distance);
  }
  return plank;
}

std::array<Scale, 3> scales_at(double u, double v) {
  constexpr double tip = 1.20;    // how far a scale reaches down over the next row, in rows
  constexpr double rise = 1.42;   // at its sides the free edge is this much higher than at the tip
  constexpr double soft = 0.014;  // width of the rounded rim

  std::array<Scale, 3> scales;
  int row = static_cast<int>(std::floor(v * scale_rows));
  for (Scale& scale : scales) {
    const Dual across = Dual::u(u) * scale_columns - (row % 2 != 0 ? 0.5 : 0.0);
    const int column = floor_of(across);
    scale.row = wrap(row, scale_rows);
    scale.column = wrap(column, scale_columns);
    scale.x = across - (column + 0.5);
    scale.y = Dual::v(v) * scale_rows - row;
    // Free edge: a shield, y = -tip + rise |2x|^3. The height above it, over the slope, is nearly its
    // distance.
    const Dual side = 2.0 * abs(scale.x);
    const Dual above = (scale.y + tip - rise * side * side * side) / scale_rows;
    const Dual slope = 6.0 * rise * side * side * (double(scale_columns) / scale_rows);
    scale.rim = above / sqrt(1.0 + slope * slope);
    scale.cover = smooth_step(0, soft, scale.rim);
    ++row;
  }
  scales[0].cover = 1.0;
  return scales;
}

}  // namespace texel::procedural
