// SPDX-License-Identifier: MIT
#include "scene.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "objects.hpp"
#include "procedural/noise.hpp"
#include "procedural/shapes.hpp"
#include "terrain.hpp"

namespace texel::assets {

namespace {

using glm::dvec2;
using glm::dvec3;
using procedural::fbm;
using procedural::noise;
using procedural::smooth_step;

constexpr double tau = 2 * std::numbers::pi;
const dvec3 eye(0, 2.6, 0);
const dvec3 sun = glm::normalize(dvec3(-0.76, 0.50, 0.42));
const dvec3 sunlight(2.35, 2.10, 1.72);
const dvec3 haze(0.60, 0.72, 0.86);

/// 0 in the middle of the lake, 1 at its shore.
double lake(double x, double z) {
  const double shore = std::hypot((x - 15) / 140, (z + 152) / 126);
  return shore + 0.10 * fbm(dvec3(x / 34, 0, z / 34), 4, 201);
}

/// Distance to the middle of the path, which winds from the square to the village.
double path(double x, double z) {
  return std::abs(x - 2.4 * std::sin(z * 0.075) - 0.03 * z);
}

bool tree_may_stand(double x, double z) {
  const bool is_view = z < 0 && std::abs(x) < 16 - 0.35 * z && z > -40;  // leave the lake to be seen
  return lake(x, z) > 1.10 && !is_view && (z < 0 || path(x, z) > 5);
}

// ---- the sky

double cloud_density(dvec2 p) {
  const double shape = fbm(dvec3(p * 0.55, 0.3), 3, 211) + 0.55 * fbm(dvec3(p * 1.7, 1.7), 5, 212);
  return smooth_step(0.04, 0.52, shape);
}

dvec3 sky(dvec3 d) {
  const double up = std::max(d.y, 0.0);
  dvec3 light = glm::mix(dvec3(0.075, 0.200, 0.560), dvec3(0.30, 0.50, 0.86), std::pow(1 - up, 2.2));
  light = glm::mix(light, haze, std::pow(1 - up, 9.0));
  const double towards_sun = std::max(glm::dot(d, sun), 0.0);
  light += dvec3(1.0, 0.78, 0.45) * (0.28 * std::pow(towards_sun, 8.0) + 0.9 * std::pow(towards_sun, 90.0));
  if (d.y > 0.015) {
    const dvec2 p = dvec2(d.x, d.z) / (d.y + 0.09);  // a high layer; the 0.09 bends it down at the horizon
    const double density = cloud_density(p) * smooth_step(0.015, 0.16, d.y);
    if (density > 0) {
      // Thick where the cloud lies between us and the sun: grey below, bright at the edge that faces it.
      const double shade = cloud_density(p + 0.22 * dvec2(sun.x, sun.z));
      const dvec3 cloud = glm::mix(dvec3(1.85, 1.79, 1.70), dvec3(0.72, 0.78, 0.90), 0.75 * shade * density);
      light = glm::mix(light, cloud + dvec3(1.0, 0.8, 0.5) * std::pow(towards_sun, 12.0), 0.92 * density);
    }
  }
  return light + dvec3(60, 54, 42) * smooth_step(0.99955, 0.99975, glm::dot(d, sun));
}

// ---- the ground

dvec3 paving(double x, double z) {
  const double r = std::hypot(x, z), turns = std::atan2(x, -z) / tau;
  if (r > 7.55)
    return dvec3(0.46, 0.44, 0.40) * (0.9 + 0.2 * noise(dvec3(x * 6, 0, z * 6), 221));  // the kerb
  if (r < 2.5) {  // a compass rose: four long points over four short ones, each half light, half dark
    const double x8 = (x - z) * std::numbers::sqrt2 / 2,
                 z8 = (x + z) * std::numbers::sqrt2 / 2;  // an eighth turn on
    const bool is_long = procedural::in_star(x, -z, 4, 2.3, 0.62);
    if (is_long || procedural::in_star(x8, z8, 4, 1.65, 0.62)) {
      const bool is_dark = std::remainder(is_long ? turns : turns - 0.125, 0.25) > 0;
      if (is_long && std::abs(turns) < 0.125)
        return is_dark ? dvec3(0.42, 0.030, 0.022) : dvec3(0.62, 0.075, 0.05);
      return is_dark ? dvec3(0.045, 0.055, 0.085) : dvec3(0.60, 0.56, 0.47);
    }
    const dvec3 gravel = r > 2.36 ? dvec3(0.10, 0.10, 0.11) : dvec3(0.36, 0.32, 0.26);
    return gravel * (1 + 0.5 * fbm(dvec3(x * 11, 0, z * 11), 3, 222));
  }
  // Rings of stones, the joints of each ring turned against the next.
  const double ring = (r - 2.5) / 0.63;
  const int ring_index = static_cast<int>(std::floor(ring));
  const int count = 14 + 4 * ring_index;
  const double stone = turns * count + 0.5 * (ring_index % 2);
  const int stone_index = procedural::wrap(static_cast<int>(std::floor(stone)), count);
  const double edge_r = std::min(ring - ring_index, ring_index + 1 - ring) * 0.63;
  const double edge_a = std::min(stone - std::floor(stone), std::floor(stone) + 1 - stone) * tau * r / count;
  const double joint = smooth_step(0.012, 0.030, std::min(edge_r, edge_a));
  const dvec3 tone = glm::mix(dvec3(0.36, 0.30, 0.24), dvec3(0.27, 0.26, 0.26),
                              procedural::random(ring_index, stone_index, 223));
  const dvec3 slab = tone * (0.80 + 0.4 * procedural::random(ring_index, stone_index, 224)) *
                     (1 + 0.35 * fbm(dvec3(x * 5, 0, z * 5), 4, 225));
  return glm::mix(dvec3(0.075, 0.075, 0.062), slab, joint);
}

dvec3 meadow(double x, double z, double distance) {
  const double patch = fbm(dvec3(x / 21, 0, z / 21), 4, 231);
  dvec3 grass = glm::mix(dvec3(0.070, 0.130, 0.022), dvec3(0.150, 0.175, 0.040), 0.5 + 1.1 * patch);
  // Blades are seen near by only; further off they are what they are on average.
  const double near = std::exp(-distance / 22);
  grass *= 1 +
           near * (0.75 * noise(dvec3(x * 13, 0, z * 13), 232) + 0.5 * noise(dvec3(x * 31, 0, z * 31), 233)) +
           0.22 * fbm(dvec3(x * 0.9, 0, z * 0.9), 3, 234);
  const int i = static_cast<int>(std::floor(x / 0.45)), j = static_cast<int>(std::floor(z / 0.45));
  if (distance < 45 && procedural::random(i, j, 235) < 0.30 * smooth_step(-0.12, 0.22, patch)) {  // flowers
    const double fx = x / 0.45 - i - 0.25 - 0.5 * procedural::random(i, j, 236);
    const double fz = z / 0.45 - j - 0.25 - 0.5 * procedural::random(i, j, 237);
    if (std::hypot(fx, fz) < 0.13) {
      const double kind = procedural::random(i, j, 238);
      return kind < 0.5 ? dvec3(0.80) : kind < 0.8 ? dvec3(0.80, 0.55, 0.03) : dvec3(0.62, 0.04, 0.05);
    }
  }
  return grass;
}

dvec3 ground_colour(double x, double z, double distance) {
  if (std::hypot(x, z) < 7.9) return paving(x, z);
  dvec3 ground = meadow(x, z, distance);
  const dvec3 sand =
      dvec3(0.43, 0.35, 0.235) * (1 + 0.25 * fbm(dvec3(x * 2, 0, z * 2), 4, 241) +
                                  0.4 * std::exp(-distance / 18) * noise(dvec3(x * 24, 0, z * 24), 242));
  const double ragged = 0.5 * fbm(dvec3(x, 0, z), 3, 243);
  if (z > 0) ground = glm::mix(sand, ground, smooth_step(1.2, 1.7, path(x, z) + ragged));
  const double shore = lake(x, z) + 0.02 * ragged;
  ground = glm::mix(sand * 0.95, ground, smooth_step(1.035, 1.065, shore));
  return ground * (0.45 + 0.55 * smooth_step(1.0, 1.012, shore));  // wet at the water's edge
}

/// Of the ground at p, whose normal is n.
dvec3 mountain_colour(dvec3 p, dvec3 n) {
  const double rough = fbm(p / 90.0, 5, 251);
  const double woods = smooth_step(-0.10, 0.06, fbm(p / 260.0, 5, 252));
  dvec3 slope = glm::mix(dvec3(0.095, 0.140, 0.032), dvec3(0.026, 0.062, 0.020), woods);
  slope *= 1 + 0.8 * fbm(p / 24.0, 3, 253);
  const dvec3 rock = glm::mix(dvec3(0.17, 0.145, 0.125), dvec3(0.085, 0.085, 0.095), 0.5 + 1.4 * rough);
  slope = glm::mix(slope, rock, smooth_step(0.80, 0.68, n.y + 0.15 * rough));
  slope = glm::mix(slope, rock, smooth_step(330, 520, p.y + 300 * rough));
  const double snow = smooth_step(400, 580, p.y + 300 * rough) * smooth_step(0.46, 0.56, n.y + 0.25 * rough);
  return glm::mix(slope, dvec3(0.88, 0.91, 0.96), snow);
}

// ---- light

dvec3 lit(dvec3 albedo, dvec3 n, double sun_part, double sky_part) {
  const dvec3 from_sky = dvec3(0.42, 0.56, 0.80) * (0.55 + 0.45 * n.y) * sky_part;
  const dvec3 from_ground = dvec3(0.13, 0.13, 0.07) * (0.5 - 0.5 * n.y);
  return albedo * (sunlight * (sun_part * std::max(glm::dot(n, sun), 0.0)) + from_sky + from_ground);
}

dvec3 in_haze(dvec3 light, double distance, double reach) {
  return glm::mix(haze * 0.92, light, std::exp(-distance / reach));
}

/// The light that comes along a ray; `is_mirrored` once it has left the lake, which is not met again.
dvec3 radiance(dvec3 origin, dvec3 d, bool is_mirrored) {
  static const Terrain terrain;
  static const Objects objects(tree_may_stand);

  const double flat = d.y < 0 ? -origin.y / d.y : 1e9;
  const dvec3 foot = origin + flat * d;
  const bool is_near = !is_mirrored && d.y < 0 && std::hypot(foot.x, foot.z) < 300;
  const Hit hit = objects.intersect(origin, d, std::min(flat, 400.0));
  if (hit.t > 0) {
    const dvec3 p = origin + hit.t * d;
    const dvec3 light = lit(hit.albedo, hit.normal, objects.sunlight(p + 0.03 * hit.normal, sun), hit.sky);
    return in_haze(light, hit.t, 2600);
  }
  if (is_near) {
    if (lake(foot.x, foot.z) < 1.0) {
      // Ripples that fade with distance, where many fall into one pixel.
      const double calm = 0.030 * std::exp(-flat / 140) + 0.004;
      const dvec3 q(foot.x * 0.8, 0, foot.z * 2.2);
      const dvec3 n = glm::normalize(dvec3(calm * fbm(q, 3, 261), 1, calm * 1.6 * fbm(q, 3, 271)));
      const dvec3 mirrored = d - 2 * glm::dot(d, n) * n;
      const double cosine = -glm::dot(d, n);
      const double fresnel = 0.02 + 0.98 * std::pow(1 - cosine, 5.0);  // Schlick, water
      const dvec3 up(mirrored.x, std::abs(mirrored.y), mirrored.z);
      const dvec3 depths(0.020, 0.085, 0.105);
      return in_haze(glm::mix(depths, radiance(foot, up, true), fresnel), flat, 2600);
    }
    const dvec3 light = lit(ground_colour(foot.x, foot.z, flat), {0, 1, 0}, objects.sunlight(foot, sun), 1);
    return in_haze(light, flat, 2600);
  }
  const double t = terrain.intersect(origin, d);
  if (t > 0) {
    const dvec3 p = origin + t * d;
    const dvec3 n = terrain.normal(p.x, p.z);
    // Crags finer than the grid turn the light, not the snow.
    const dvec3 crags(fbm(p / 60.0, 4, 281), 0, fbm(p / 60.0, 4, 282));
    const dvec3 craggy = glm::normalize(n + 0.6 * smooth_step(150, 500, p.y) * crags);
    return in_haze(lit(mountain_colour(p, n), craggy, 1, 1), t, 9000);
  }
  return sky(d);
}

/// Bright light bends towards white: the fit of the ACES film curve by Narkowicz (2015).
dvec3 film(dvec3 x) {
  x *= 0.62;
  return glm::clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

}  // namespace

glm::dvec3 scene_colour(glm::dvec3 direction) {
  return film(radiance(eye, direction, false));
}

}  // namespace texel::assets
