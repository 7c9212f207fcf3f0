// SPDX-License-Identifier: MIT
#include "procedural/textures.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <numbers>

#include "procedural/noise.hpp"
#include "procedural/patterns.hpp"
#include "procedural/shapes.hpp"

// Colours in this file are linear light: 0.2 is what a screen shows as 124 of 255.
namespace texel::procedural {

namespace {

using glm::dvec3;
using glm::dvec4;
constexpr double tau = 2 * std::numbers::pi;

dvec3 blend(dvec3 from, dvec3 to, double t) {
  return from + (to - from) * std::clamp(t, 0.0, 1.0);
}

dvec3 brick(double u, double v) {
  const auto brick = brick_at(u, v);
  const auto own = [&](std::uint32_t seed) { return random(brick.column, brick.row, seed); };
  // Fired clay from orange to a burnt dark red; a few bricks stand out.
  dvec3 clay = blend({0.33, 0.085, 0.040}, {0.185, 0.043, 0.028}, own(101));
  if (own(102) < 0.18) clay = blend(clay, {0.075, 0.030, 0.028}, 0.75);
  if (own(103) < 0.15) clay = blend(clay, {0.46, 0.175, 0.085}, 0.7);
  const double cloud = fbm(u, v, 9, 12, 4, 104);
  const double grain = fbm(u, v, 70, 70, 2, 105);
  clay *= 1.0 + 0.55 * cloud + 0.45 * grain;
  // The kiln's darker rims, chalk that bled out, and black specks.
  const double x = brick.x * 8, y = brick.y * 16;
  clay *= 1.0 - 0.28 * smooth_step(0.45, 1.05, std::sqrt(x * x * x * x + y * y * y * y) + 0.5 * cloud);
  clay = blend(clay, {0.52, 0.40, 0.33}, 0.35 * smooth_step(0.22, 0.60, fbm(u, v, 6, 10, 4, 106)));
  clay =
      blend(clay, {0.035, 0.022, 0.020}, 0.75 * smooth_step(0.30, 0.48, noise(u * 90, v * 90, 90, 90, 107)));

  dvec3 mortar = dvec3(0.43, 0.395, 0.34) * (1.0 + 0.35 * fbm(u, v, 12, 12, 3, 108));
  mortar *= 1.0 + 0.7 * fbm(u, v, 90, 90, 2, 109);
  // The joint lies deep, so less of the sky reaches its sides.
  const double inside = brick.inside;
  mortar *= 0.62 + 0.38 * smooth_step(0.6, 0.0, inside);
  return blend(mortar, clay * (0.72 + 0.28 * inside), smooth_step(0.12, 0.42, inside));
}

dvec3 wood(double u, double v) {
  const Plank plank = plank_at(u, v);
  const double x = plank.x.value, y = plank.y.value;
  const auto own = [&](std::uint32_t seed) { return random(plank.row, 0, seed); };
  const auto seed = static_cast<std::uint32_t>(120 + plank.row);
  // Within a ring the colour darkens slowly from early to late wood and falls back fast.
  const double phase = tau * plank.ring.value;
  const double late = std::pow(0.5 + 0.5 * std::sin(phase + 0.5 * std::sin(phase)), 1.6);
  const dvec3 early_wood = blend({0.50, 0.265, 0.105}, {0.40, 0.185, 0.068}, own(111));
  const dvec3 late_wood = blend({0.235, 0.090, 0.028}, {0.165, 0.058, 0.019}, own(112));
  const double broad = noise(x * 5, y * 14, 256, 256, seed);
  dvec3 tint = blend(early_wood, late_wood, 0.85 * late * (0.75 + 0.6 * broad) + 0.18 * own(113));
  const double fibre =
      noise(x * 10, y * 170, 256, 256, seed + 10) + 0.6 * noise(x * 24, y * 420, 512, 512, seed + 20);
  tint *= 0.82 + 0.36 * own(114) + 0.34 * fibre + 0.30 * broad;
  // Vessels cut lengthwise show as short dark streaks.
  tint *= 1.0 - 0.5 * smooth_step(0.24, 0.5, noise(x * 22, y * 130, 256, 256, seed + 30));
  tint = blend(tint, {0.060, 0.020, 0.008}, 0.9 * std::pow(plank.knot.value, 1.5));
  return tint * (0.10 + 0.90 * std::pow(plank.inside.value, 0.7));
}

dvec3 scales(double u, double v) {
  dvec3 sum(0);
  for (const Scale& scale : scales_at(u, v)) {
    const auto own = [&](std::uint32_t seed) { return random(scale.column, scale.row, seed); };
    const double x = scale.x.value, y = scale.y.value, rim = scale.rim.value;
    dvec3 skin = blend({0.060, 0.115, 0.030}, {0.105, 0.130, 0.034}, own(141));
    if (own(142) < 0.25) skin = blend(skin, {0.030, 0.060, 0.026}, 0.8);
    const double cloud = fbm(u, v, 20, 20, 3, 143);
    skin *= 1.0 + 0.7 * cloud;
    // Lighter horn along the keel and the free edge, dark skin where the scale is held.
    skin = blend(skin, {0.30, 0.30, 0.085}, 0.55 * std::exp(-90.0 * x * x) + 0.25 * cloud);
    skin = blend(skin, {0.36, 0.31, 0.12}, 0.75 * smooth_step(0.022, 0.004, rim));
    skin *= 1.0 - 0.55 * smooth_step(-0.75, 0.05, y + 0.3 * cloud);
    skin *= 1.0 + 0.5 * noise(u * 120, v * 60, 120, 60, 144);
    // A scale shades the one below it close to its edge.
    sum *= 1.0 - 0.75 * smooth_step(-0.020, 0.002, rim);
    sum = blend(sum, skin, scale.cover.value <= 0 ? 0 : smooth_step(0.0, 0.4, scale.cover.value));
  }
  return sum;
}

dvec3 smile(double u, double v) {
  const double x = 2 * (u - std::floor(u)) - 1, y = 2 * (v - std::floor(v)) - 1;
  const double r = std::hypot(x, y);
  dvec3 sum = blend({0.045, 0.30, 0.62}, {0.020, 0.155, 0.42}, 0.75 * r * r);  // sky-blue ground
  sum *= 1.0 - 0.45 * smooth_step(0.98, 0.78, std::hypot(x, y + 0.05));        // the face's soft shadow
  if (r < 0.84) sum = {0.30, 0.105, 0.004};                                    // outline
  if (r < 0.80) {
    const double light = 1.0 - 0.55 * std::hypot(x + 0.25, y - 0.35);
    sum = blend({0.80, 0.38, 0.010}, {1.0, 0.80, 0.11}, 0.25 + light);
    const double cheek = std::min(std::hypot(x - 0.47, y + 0.10), std::hypot(x + 0.47, y + 0.10));
    sum = blend(sum, {0.95, 0.20, 0.045}, 0.45 * smooth_step(0.20, 0.02, cheek));
    // Eyes: tall ovals with a glint.
    const double eye_x = std::abs(x) - 0.27, eye_y = y - 0.24;
    if (std::hypot(eye_x / 0.085, eye_y / 0.155) < 1) sum = {0.020, 0.010, 0.006};
    if (std::hypot(std::abs(x + 0.028) - 0.27, eye_y - 0.065) < 0.032) sum = {1, 1, 1};
    // Mouth: the lower part of a disc, cut by a flatter curve; tongue and teeth inside.
    const double lip = -0.20 + 0.12 * x * x;
    if (std::hypot(x, y + 0.10) < 0.52 && y < lip) {
      sum = {0.14, 0.010, 0.010};
      if (y > lip - 0.085) sum = {0.95, 0.93, 0.88};
      if (std::hypot(x / 1.25, y + 0.62) < 0.20) sum = {0.75, 0.085, 0.065};
    }
  }
  return sum;
}

/// A colour of full saturation from its hue in turns, by three raised cosines.
dvec3 hue(double turns) {
  return {0.5 + 0.5 * std::cos(tau * turns), 0.5 + 0.5 * std::cos(tau * (turns - 1.0 / 3)),
          0.5 + 0.5 * std::cos(tau * (turns - 2.0 / 3))};
}

dvec3 label_grid(double u, double v) {
  const dvec3 ink(0.012), paper(0.95);
  const double x = 8 * (u - std::floor(u)), y = 8 * (v - std::floor(v));
  const int column = std::min(static_cast<int>(x), 7), row = std::min(static_cast<int>(y), 7);
  const double cx = x - column, cy = y - row;

  if ((column == 3 || column == 4) && (row == 3 || row == 4)) {  // the axes, on a field of 2 x 2 cells
    const double ax = x - 3.28, ay = y - 3.28;
    if (in_arrow(ax, ay, 1.45, 0.13)) return {0.75, 0.02, 0.02};
    if (in_arrow(ay, ax, 1.45, 0.13)) return {0.01, 0.42, 0.03};
    if (in_text("s", (x - 4.26) / 0.075, (y - 3.60) / 0.075, 0.75)) return {0.75, 0.02, 0.02};
    if (in_text("t", (x - 3.58) / 0.075, (y - 4.22) / 0.075, 0.75)) return {0.01, 0.42, 0.03};
    const bool border = x < 3.035 || x > 4.965 || y < 3.035 || y > 4.965;
    return border ? ink : paper;
  }
  if ((column == 0 || column == 7) && (row == 0 || row == 7)) {  // the corners
    const int corner = (column == 7 ? 1 : 0) + (row == 7 ? 2 : 0);
    constexpr dvec3 grounds[] = {
        {0.72, 0.012, 0.012}, {0.015, 0.40, 0.03}, {0.02, 0.07, 0.75}, {0.95, 0.68, 0.01}};
    const char letter[] = {static_cast<char>('A' + corner)};
    const double size = 0.118;
    const bool is_letter = in_text({letter, 1}, (cx - 0.5) / size + 2, (cy - 0.5) / size + 3, 0.85);
    return is_letter ? (corner == 3 ? ink : paper) : grounds[corner];
  }
  const bool dark = (column + row) % 2 == 0;
  const dvec3 ground = blend(hue(column / 8.0 + 0.03 * row), paper, dark ? 0.35 : 0.72) * (0.45 + 0.07 * row);
  const char label[] = {static_cast<char>('A' + column), static_cast<char>('1' + row)};
  const double size = 0.068;
  if (in_text({label, 2}, (cx - 0.5) / size + 5, (cy - 0.5) / size + 3, 0.62)) return ink;
  const bool border = cx < 0.02 || cx > 0.98 || cy < 0.02 || cy > 0.98;
  return border ? ground * 0.35 : ground;
}

dvec3 checker(double u, double v) {
  const auto field = static_cast<long long>(std::floor(8 * u)) + static_cast<long long>(std::floor(8 * v));
  return dvec3(field % 2 == 0 ? 0 : 1);
}

dvec3 sine_sweep(double u, double v) {
  const double x = u - std::floor(u) - 0.5, y = v - std::floor(v) - 0.5;
  // Phase k r^2 / 2 has the frequency k r / tau: 256 at the corners, r^2 = 1/2.
  constexpr double k = tau * 256 * std::numbers::sqrt2;
  return dvec3(0.5 + 0.5 * std::cos(0.5 * k * (x * x + y * y)));
}

dvec3 stripes(double u, double) {
  return dvec3(0.5 - 0.5 * std::cos(8 * tau * u));
}

dvec3 clouds(double u, double v) {
  const double warp = fbm(u, v, 4, 4, 5, 161);
  const double cloud = fbm(u + 0.10 * warp, v + 0.10 * fbm(u, v, 4, 4, 5, 171), 4, 4, 7, 181);
  return dvec3(smooth_step(-0.75, 0.75, cloud));
}

dvec4 decal(double u, double v) {
  const double x = 2 * (u - std::floor(u)) - 1, y = 2 * (v - std::floor(v)) - 1;
  const double r = std::hypot(x, y), angle = std::atan2(x, y);
  const dvec3 gold = blend({0.55, 0.27, 0.022}, {1.0, 0.72, 0.22}, 0.5 + 0.5 * (0.6 * y - 0.8 * x));
  const dvec3 navy = blend({0.010, 0.028, 0.135}, {0.018, 0.085, 0.30}, 0.5 + 0.5 * y);
  const double scallop = 0.86 + 0.025 * std::cos(24 * angle);
  dvec3 tint = gold;
  if (r < 0.79) tint = navy;
  if (r < 0.56) tint = gold;
  if (r < 0.535) tint = blend({0.50, 0.010, 0.014}, {0.80, 0.035, 0.025}, 0.5 + 0.6 * (y - x));
  if (in_star(x, y, 5, 0.46, 0.19)) tint = {1.0, 0.93, 0.75};
  // The word bends around the ring: along it, an angle is a length.
  const double ring = 0.675, size = 0.026;
  const double top = std::remainder(angle, tau) * ring / size, out = (r - ring) / size;
  if (in_text("TEXEL", top + 0.5 * text_width("TEXEL"), out + 3, 0.75)) tint = {1.0, 0.93, 0.75};
  const double bottom = -std::remainder(angle - tau / 2, tau) * ring / size;
  if (in_text("LABS", bottom + 0.5 * text_width("LABS"), 3 - out, 0.75)) tint = {1.0, 0.93, 0.75};
  return {tint, smooth_step(scallop + 0.05, scallop - 0.03, r)};
}

dvec3 light_map(double u, double v) {
  const double x = 2 * (u - std::floor(u)) - 1, y = 2 * (v - std::floor(v)) - 1;
  const double r = std::hypot(x - 0.10, y - 0.12);
  return dvec3(0.035 + 0.965 * std::pow(smooth_step(0.86, 0.05, r), 1.3));
}

template <dvec3 texture(double u, double v)>
dvec4 opaque(double u, double v) {
  return {texture(u, v), 1};
}

/// In the order of the enumerators.
constexpr struct {
  const char* name;
  dvec4 (*color)(double u, double v);
} all[] = {{"brick", opaque<brick>},           {"wood", opaque<wood>},
           {"scales", opaque<scales>},         {"smile", opaque<smile>},
           {"label_grid", opaque<label_grid>}, {"checker", opaque<checker>},
           {"sine_sweep", opaque<sine_sweep>}, {"stripes", opaque<stripes>},
           {"noise", opaque<clouds>},          {"decal", decal},
           {"light_map", opaque<light_map>}};

}  // namespace

const char* name(Texture texture) {
  return all[static_cast<int>(texture)].name;
}

glm::dvec4 color(Texture texture, double u, double v) {
  return glm::clamp(all[static_cast<int>(texture)].color(u, v), 0.0, 1.0);
}

}  // namespace texel::procedural
