// SPDX-License-Identifier: MIT
#include "procedural/height_fields.hpp"

#include <glm/geometric.hpp>
#include <numbers>

#include "procedural/noise.hpp"
#include "procedural/patterns.hpp"

namespace texel::procedural {

namespace {

constexpr double tau = 2 * std::numbers::pi;

Dual brick(double u, double v) {
  const auto brick = brick_at(Dual::u(u), Dual::v(v));
  const Dual up = Dual::u(u), vp = Dual::v(v);
  const auto own = [&](std::uint32_t seed) { return random(brick.column, brick.row, seed) - 0.5; };
  const Dual mortar = 0.0012 * fbm(up, vp, 40, 40, 3, 51);
  const Dual face = 0.009 + 0.003 * own(52) + 0.03 * own(53) * brick.x + 0.06 * own(54) * brick.y +
                    0.0022 * fbm(up, vp, 14, 20, 4, 55) -
                    0.0028 * smooth_step(0.25, 0.5, fbm(up, vp, 26, 26, 2, 56));
  return mix(mortar, face, brick.inside);
}

Dual wood(double u, double v) {
  const Plank plank = plank_at(u, v);
  const auto seed = static_cast<std::uint32_t>(60 + plank.row);
  // The dark late wood of each ring stands a little higher; sin(p + sin(p) / 2) rises slowly and falls fast.
  const Dual phase = tau * plank.ring;
  const Dual ring = 0.0007 * sin(phase + 0.5 * sin(phase));
  const Dual fibre = 0.0006 * noise<Dual>(plank.x * 10.0, plank.y * 170.0, 256, 256, seed);
  const Dual pore =
      -0.0010 * smooth_step(0.28, 0.5, noise<Dual>(plank.x * 22.0, plank.y * 130.0, 256, 256, seed + 10));
  const Dual warp = 0.0012 * noise<Dual>(plank.x * 4.0, plank.y * 10.0, 256, 256, seed + 20);
  return plank.inside * (0.006 + ring + fibre + pore + warp - 0.0025 * plank.knot);
}

Dual scales(double u, double v) {
  const Dual up = Dual::u(u), vp = Dual::v(v);
  Dual sum = 0.0;
  for (const Scale& scale : scales_at(u, v)) {
    const double own = random(scale.column, scale.row, 71) - 0.5;
    // Held at y = 0 and lifted towards its tip, domed across, with a keel along its middle.
    const Dual lift = -0.013 * scale.y;
    const Dual dome = 0.014 * (1.0 - 4.0 * scale.x * scale.x);
    const Dual keel = 0.007 * exp(-60.0 * scale.x * scale.x) * smooth_step(0.002, 0.030, scale.rim);
    const Dual tilt = 0.006 * own * scale.x;
    sum = mix(sum, lift + dome + keel + tilt, scale.cover);
  }
  return sum + 0.0008 * fbm(up, vp, 32, 32, 3, 73);
}

/// Six waves of one length, as (3, 4) and (5, 0) have one length: smooth bumps that favour no direction.
Dual bump(double u, double v) {
  const Dual p = tau * Dual::u(u), q = tau * Dual::v(v);
  return 0.006 * (sin(5.0 * p) + sin(5.0 * q) + sin(4.0 * p + 3.0 * q) + cos(3.0 * p - 4.0 * q) +
                  sin(4.0 * p - 3.0 * q) + cos(3.0 * p + 4.0 * q));
}

}  // namespace

Dual height(HeightField field, double u, double v) {
  constexpr Dual (*heights[])(double u, double v) = {brick, wood, scales, bump};
  return heights[static_cast<int>(field)](u, v);
}

glm::dvec3 normal(HeightField field, double u, double v, double strength) {
  const Dual h = height(field, u, v);
  return glm::normalize(glm::dvec3(-strength * h.du, -strength * h.dv, 1));
}

}  // namespace texel::procedural
