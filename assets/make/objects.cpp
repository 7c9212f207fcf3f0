// SPDX-License-Identifier: MIT
#include "objects.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <numbers>

#include "procedural/noise.hpp"

namespace texel::assets {

namespace {

using glm::dvec2;
using glm::dvec3;
using Kind = Object::Kind;

/// A distance with what the surface is made of.
struct Surface {
  double distance;
  dvec3 albedo;
  double sky = 1;
};

Surface nearer(Surface a, Surface b) {
  return a.distance < b.distance ? a : b;
}

double box(dvec3 p, dvec3 half) {
  const dvec3 q = glm::abs(p) - half;
  return glm::length(glm::max(q, 0.0)) + std::min(std::max({q.x, q.y, q.z}), 0.0);
}

/// An upright cylinder, or a part of a cone, from y = low to high.
double cone(dvec3 p, double low, double high, double radius_low, double radius_high) {
  const double along = std::clamp((p.y - low) / (high - low), 0.0, 1.0);
  const double radius = radius_low + along * (radius_high - radius_low);
  const double slope = (radius_low - radius_high) / (high - low);
  const double side = (std::hypot(p.x, p.z) - radius) / std::sqrt(1 + slope * slope);
  return std::max({side, low - p.y, p.y - high});
}

/// A roof of two slopes over |x| < half_width, its ridge along z at `ridge`, its eaves at `eaves`.
double gable(dvec3 p, double half_width, double half_length, double eaves, double ridge) {
  const double rise = (ridge - eaves) / half_width;
  const double slope = (p.y - ridge + rise * std::abs(p.x)) / std::sqrt(1 + rise * rise);
  return std::max({slope, eaves - p.y, std::abs(p.z) - half_length});
}

std::vector<Ball> crown_lobes(std::uint32_t seed) {
  const auto own = [&](int which) { return procedural::random(which, 0, seed); };
  std::vector<Ball> lobes{{{0, 4.1 + 1.1 * own(10), 0}, 1.05 + 0.40 * own(20)}};
  for (int lobe = 1; lobe < 7; ++lobe) {
    const double angle = 2.4 * lobe + 6.3 * own(1), out = 0.9 + 0.5 * own(30 + lobe);
    const dvec3 middle(out * std::cos(angle), 2.6 + 1.1 * own(10 + lobe), out * std::sin(angle));
    lobes.push_back({middle, 1.05 + 0.40 * own(20 + lobe)});
  }
  return lobes;
}

Surface broadleaf(dvec3 p, std::uint32_t seed, const std::vector<Ball>& lobes) {
  double crown = 1e9;
  for (const Ball& lobe : lobes) crown = std::min(crown, glm::distance(p, lobe.middle) - lobe.radius);
  const Surface trunk{cone(p, -0.2, 4.0, 0.26, 0.14), dvec3(0.10, 0.068, 0.045)};
  if (crown > 0.5) return nearer({crown - 0.26, dvec3(0)}, trunk);  // far off, its leaves do not matter
  const double leaves = procedural::fbm(p * 2.2, 4, seed + 1);
  const dvec3 green =
      glm::mix(dvec3(0.060, 0.135, 0.020), dvec3(0.135, 0.180, 0.026), procedural::random(2, 0, seed));
  const double sky = 0.55 + 0.45 * std::clamp((p.y - 1.8) / 3.0, 0.0, 1.0);
  return nearer({0.7 * (crown - 0.9 * std::min(leaves, 0.28)), green * (0.85 + 1.2 * leaves), sky}, trunk);
}

Surface conifer(dvec3 p, std::uint32_t seed) {
  const double out = std::hypot(p.x, p.z), angle = std::atan2(p.z, p.x);
  // Whorls of branches: within each, the radius grows downwards.
  const double whorl = p.y * 1.5 + 0.25 * std::sin(3 * angle + 6.3 * procedural::random(0, 0, seed));
  const double drop = whorl - std::floor(whorl);
  const double radius = (7.2 - p.y) * 0.27 * (1.0 - 0.42 * drop);
  const Surface trunk{cone(p, -0.2, 1.2, 0.20, 0.18), dvec3(0.085, 0.055, 0.038)};
  if (out - radius > 0.8) return nearer({0.5 * (out - radius - 0.3), dvec3(0)}, trunk);
  const double needles = procedural::fbm(p * dvec3(3.2, 2.0, 3.2), 4, seed + 1);
  const double ragged = 0.5 * std::clamp(needles, -1.0, 0.5) * std::min(1.0, 7.2 - p.y);
  const double side = std::max({0.55 * (out - radius - ragged), 0.7 - p.y, p.y - 7.2});
  const dvec3 green =
      glm::mix(dvec3(0.024, 0.066, 0.026), dvec3(0.045, 0.092, 0.030), procedural::random(1, 0, seed));
  const double sky = 0.4 + 0.6 * std::clamp(out / (radius + 0.2), 0.0, 1.0);
  return nearer({side, green * (0.85 + 1.2 * needles), sky}, trunk);
}

/// Whether (x, y) lies in one of a row of windows, each half_width wide about multiples of `spacing`.
bool in_window(double x, double y, double spacing, double half_width, double low, double high) {
  return std::abs(std::remainder(x, spacing)) < half_width && y > low && y < high;
}

/// A wall with white-framed windows; `along` runs along the wall.
dvec3 wall_colour(dvec3 plaster, double along, double y, double spacing, double low, double high) {
  if (in_window(along, y, spacing, 0.42, low, high)) {
    const bool bar =
        std::abs(std::remainder(along, spacing)) < 0.04 || std::abs(y - 0.5 * (low + high)) < 0.04;
    return bar ? dvec3(0.75) : dvec3(0.035, 0.055, 0.080);
  }
  if (in_window(along, y, spacing, 0.54, low - 0.12, high + 0.12)) return dvec3(0.78);
  return plaster * (0.95 + 0.12 * procedural::noise(dvec3(along * 2, y * 2, 0), 320));
}

dvec3 tiles(dvec3 p, dvec3 clay) {
  const double row = p.y * 5, column = p.z * 4 + 0.5 * std::floor(row);
  const double tone =
      procedural::random(static_cast<int>(std::floor(row)), static_cast<int>(std::floor(column)), 321);
  return clay * (0.75 + 0.5 * tone) * (row - std::floor(row) < 0.16 ? 0.6 : 1.0);
}

/// A house of 6 x 8 m, walls 3.2 m high; its ridge runs along z.
Surface house(dvec3 p, std::uint32_t seed) {
  static constexpr dvec3 plasters[] = {
      {0.72, 0.62, 0.44}, {0.70, 0.66, 0.60}, {0.62, 0.34, 0.22}, {0.42, 0.52, 0.58}};
  const dvec3 plaster = plasters[procedural::hash(0, 0, seed) % 4];
  const bool is_front = std::abs(p.x) > std::abs(p.z) - 1.0;
  dvec3 wall = wall_colour(plaster, is_front ? p.z : p.x, p.y, 2.2, 1.1, 2.3);
  if (is_front && p.x > 0 && std::abs(p.z) < 0.62 && p.y < 2.25) {
    wall = std::abs(p.z) < 0.5 && p.y < 2.12 ? dvec3(0.16, 0.055, 0.030) : dvec3(0.78);
  }
  if (p.y < 0.45) wall = dvec3(0.23, 0.22, 0.21);
  const double body = std::min(box(p - dvec3(0, 1.6, 0), {3, 1.6, 4}), gable(p, 3.0, 4.0, 3.1, 5.5));
  const double slope = std::abs(p.y - (5.62 - 0.8 * std::abs(p.x))) / 1.28 - 0.10;
  const double roof = std::max({slope, std::abs(p.x) - 3.5, std::abs(p.z) - 4.45});
  const Surface chimney{box(p - dvec3(1.2, 5.4, 1.8), {0.35, 0.9, 0.35}), dvec3(0.26, 0.085, 0.052)};
  const dvec3 clay =
      procedural::random(1, 0, seed) < 0.6 ? dvec3(0.36, 0.095, 0.045) : dvec3(0.105, 0.085, 0.085);
  return nearer(nearer({body, wall}, {roof, tiles(p, clay)}), chimney);
}

/// A white nave with a tower of 14 m and a pointed roof.
Surface church(dvec3 p, std::uint32_t seed) {
  const dvec3 nave_place = p - dvec3(0, 0, -7);
  const double nave =
      std::min(box(nave_place - dvec3(0, 2.5, 0), {3.4, 2.5, 5.5}), gable(nave_place, 3.4, 5.5, 4.9, 8.6));
  dvec3 wall = dvec3(0.76, 0.73, 0.66) * (0.95 + 0.1 * procedural::noise(p * 2.0, seed));
  if (in_window(nave_place.z, p.y, 2.6, 0.38, 1.3, 4.0) && std::abs(p.x) > 3.2)
    wall = dvec3(0.04, 0.05, 0.08);
  const double slope = std::abs(p.y - (8.75 - 1.09 * std::abs(nave_place.x))) / 1.48 - 0.11;
  const double nave_roof = std::max({slope, std::abs(nave_place.x) - 3.9, std::abs(nave_place.z) - 5.8});

  dvec3 tower_wall = wall;
  const double across = std::abs(p.x) > std::abs(p.z) ? p.z : p.x;
  if (std::abs(across) < 0.5 && p.y > 10.8 && p.y < 12.8) tower_wall = dvec3(0.03);
  if (std::hypot(across, p.y - 9.0) < 0.85)
    tower_wall = std::hypot(across, p.y - 9.0) < 0.7 ? dvec3(0.85, 0.82, 0.70) : dvec3(0.03);
  if (std::abs(across) < 0.9 && p.y < 2.9) {
    tower_wall = std::abs(across) < 0.75 && p.y < 2.75 ? dvec3(0.13, 0.055, 0.030) : dvec3(0.30, 0.28, 0.26);
  }
  const double tower = box(p - dvec3(0, 6.8, 0), {1.9, 6.8, 1.9});
  const double spread = std::max(std::abs(p.x), std::abs(p.z));
  const double spire = std::max((spread - (20.5 - p.y) * 0.31) * 0.95, 13.5 - p.y);
  const double cross =
      std::min(box(p - dvec3(0, 21, 0), {0.06, 0.9, 0.06}), box(p - dvec3(0, 21.3, 0), {0.35, 0.06, 0.06}));
  const Surface roofs =
      nearer({nave_roof, tiles(p, {0.085, 0.085, 0.10})}, {spire, dvec3(0.070, 0.125, 0.115)});
  return nearer(nearer(nearer({nave, wall}, {tower, tower_wall}), roofs), {cross, dvec3(0.55, 0.36, 0.06)});
}

Surface lighthouse(dvec3 p) {
  const bool red = p.y > 3 && static_cast<int>(std::floor(p.y / 3)) % 2 != 0;
  dvec3 coat = red ? dvec3(0.62, 0.030, 0.022) : dvec3(0.82, 0.81, 0.78);
  if (in_window(p.x, p.y - 3 * std::floor(p.y / 3), 100, 0.25, 1.0, 1.9) && p.z > 0) coat = dvec3(0.03);
  const Surface tower{0.95 * cone(p, 0, 15, 2.0, 1.25), coat};
  const Surface base{cone(p, -1, 0.8, 4.2, 3.2), dvec3(0.20, 0.19, 0.18)};
  const double rail = std::max(std::abs(std::hypot(p.x, p.z) - 1.85) - 0.05, std::abs(p.y - 15.9) - 0.06);
  const Surface gallery{std::min(cone(p, 15, 15.3, 1.7, 2.0), rail), dvec3(0.08)};
  const bool bar = std::abs(std::remainder(std::atan2(p.z, p.x), std::numbers::pi / 4)) < 0.10;
  const Surface lantern{cone(p, 15.3, 17.4, 0.95, 0.95), bar ? dvec3(0.06) : dvec3(0.95, 0.80, 0.38)};
  const Surface dome{0.8 * cone(p, 17.4, 19.0, 1.25, 0.05), dvec3(0.62, 0.030, 0.022)};
  return nearer(nearer(nearer(tower, base), nearer(gallery, lantern)), dome);
}

/// A sailing boat of 5 m, its bow towards +x.
Surface boat(dvec3 p) {
  const double narrow = 0.85 * std::sqrt(std::max(0.0, 1 - std::pow(std::abs(p.x) / 2.7, 2.5)));
  const double hull = 0.7 * std::max({std::abs(p.z) - narrow * (0.6 + 0.4 * p.y), std::abs(p.x) - 2.7,
                                      p.y - 0.65 - 0.02 * p.x * p.x, -0.3 - p.y});
  const Surface mast{cone(p - dvec3(0.4, 0, 0), 0.2, 7.2, 0.06, 0.04), dvec3(0.18, 0.10, 0.05)};
  const double belly = std::abs(p.z - 0.25 * std::sin(0.55 * p.y)) - 0.03;
  const double main_sail =
      std::max({belly, p.x - 0.30, 1.2 - p.y, (-0.85 * (p.x - 0.3) * 2.5 + p.y - 7.0) * 0.42});
  const double fore_sail = std::max({belly, 0.55 - p.x, 0.9 - p.y, (2.6 * (p.x - 0.5) + p.y - 6.4) * 0.36});
  const Surface sails =
      nearer({0.8 * main_sail, dvec3(0.88, 0.86, 0.80)}, {0.8 * fore_sail, dvec3(0.75, 0.10, 0.06)});
  return nearer(nearer({hull, p.y > 0.42 ? dvec3(0.85) : dvec3(0.03, 0.08, 0.22)}, mast), sails);
}

/// A sphere that holds the object.
Ball ball_around(const Object& object) {
  const auto at = [&](double height, double radius) {
    return Ball{object.foot + dvec3(0, height * object.size, 0), radius * object.size};
  };
  switch (object.kind) {
    case Kind::broadleaf:
      return at(3.2, 3.9);
    case Kind::conifer:
      return at(3.6, 4.1);
    case Kind::house:
      return at(2.6, 6.6);
    case Kind::church:
      return at(8.5, 15.5);
    case Kind::lighthouse:
      return at(9.0, 11.0);
    case Kind::boat:
      break;
  }
  return at(3.4, 4.4);
}

Surface surface(const Object& object, dvec3 world) {
  const dvec3 q = (world - object.foot) / object.size;
  const double c = std::cos(object.turn), s = std::sin(object.turn);
  const dvec3 p(c * q.x - s * q.z, q.y, s * q.x + c * q.z);
  Surface result = [&] {
    switch (object.kind) {
      case Kind::broadleaf:
        return broadleaf(p, object.seed, object.lobes);
      case Kind::conifer:
        return conifer(p, object.seed);
      case Kind::house:
        return house(p, object.seed);
      case Kind::church:
        return church(p, object.seed);
      case Kind::lighthouse:
        return lighthouse(p);
      case Kind::boat:
        break;
    }
    return boat(p);
  }();
  result.distance *= object.size;
  return result;
}

/// Where the ray is inside the ball, from x to y; empty (x >= y) when it misses.
dvec2 span(const Ball& ball, dvec3 origin, dvec3 direction) {
  const dvec3 to = ball.middle - origin;
  const double along = glm::dot(to, direction);
  const double half_squared = ball.radius * ball.radius - (glm::dot(to, to) - along * along);
  if (half_squared <= 0) return {0, 0};
  const double half = std::sqrt(half_squared);
  return {std::max(along - half, 0.0), along + half};
}

std::vector<Object> all_objects(bool (*may_stand)(double x, double z)) {
  std::vector<Object> objects = {
      {Kind::lighthouse, {-34, 0.4, -46}, 1.0, 0.3, 1}, {Kind::boat, {17, 0, -52}, 1.1, 0.5, 2},
      {Kind::boat, {58, 0, -112}, 1.1, 2.6, 3},         {Kind::church, {12, 0, 44}, 1.0, 3.5, 4},
      {Kind::house, {-13, 0, 31}, 1.0, 0.25, 5},        {Kind::house, {-27, 0, 40}, 1.0, -0.9, 6},
      {Kind::house, {-8, 0, 58}, 1.1, 1.4, 7},          {Kind::house, {30, 0, 34}, 1.0, 2.3, 8},
      {Kind::house, {42, 0, 14}, 1.1, 2.9, 9},          {Kind::house, {-46, 0, 16}, 1.1, 0.1, 10}};
  const std::size_t built = objects.size();
  for (int i = 0; i < 420; ++i) {
    const auto own = [&](int which) { return procedural::random(i, which, 330); };
    const double radius = 17 + 190 * own(0), angle = 2 * std::numbers::pi * own(1);
    const double x = radius * std::cos(angle), z = radius * std::sin(angle);
    const bool is_free = std::all_of(objects.begin(), objects.end(), [&](const Object& other) {
      const bool is_tree = other.kind == Kind::broadleaf || other.kind == Kind::conifer;
      return std::hypot(other.foot.x - x, other.foot.z - z) > (is_tree ? 3.5 : 11.0);
    });
    if (!is_free || !may_stand(x, z)) continue;
    const bool is_conifer = own(2) < (z < 0 ? 0.75 : 0.25);
    const double size = (0.9 + 0.7 * own(3)) * (is_conifer ? 1.15 : 1.0) * (radius > 70 ? 1.3 : 1.0);
    const auto seed = static_cast<std::uint32_t>(built) + static_cast<std::uint32_t>(i);
    objects.push_back({is_conifer ? Kind::conifer : Kind::broadleaf, {x, 0, z}, size, 6.3 * own(4), seed});
    if (!is_conifer) objects.back().lobes = crown_lobes(seed);
  }
  return objects;
}

}  // namespace

Objects::Objects(bool (*may_stand)(double x, double z)) {
  std::vector<Object> rest = all_objects(may_stand);
  while (!rest.empty()) {
    constexpr std::size_t group_size = 8;
    const dvec3 first = rest.back().foot;
    std::sort(rest.begin(), rest.end(), [&](const Object& a, const Object& b) {
      return glm::distance(a.foot, first) > glm::distance(b.foot, first);
    });
    Group group{{first, 0}, {}, {}};
    for (; group.objects.size() < group_size && !rest.empty(); rest.pop_back()) {
      const Ball ball = ball_around(rest.back());
      group.ball.radius = std::max(group.ball.radius, glm::distance(ball.middle, first) + ball.radius);
      group.objects.push_back(rest.back());
      group.balls.push_back(ball);
    }
    groups_.push_back(group);
  }
}

template <class Visit>
void Objects::visit_along(glm::dvec3 origin, glm::dvec3 direction, const Visit& visit) const {
  for (const Group& group : groups_) {
    const dvec2 whole = span(group.ball, origin, direction);
    if (whole.x >= whole.y) continue;
    for (std::size_t i = 0; i < group.objects.size(); ++i) {
      const dvec2 inside = span(group.balls[i], origin, direction);
      if (inside.x < inside.y) visit(group.objects[i], inside.x, inside.y);
    }
  }
}

Hit Objects::intersect(glm::dvec3 origin, glm::dvec3 direction, double furthest) const {
  const Object* nearest = nullptr;
  visit_along(origin, direction, [&](const Object& object, double from, double to) {
    const double end = std::min(to, furthest);
    for (double t = from; t < end;) {
      const double distance = surface(object, origin + t * direction).distance;
      if (distance < 0.0004 * t + 0.002) {
        furthest = t;
        nearest = &object;
        break;
      }
      t += distance;
    }
  });
  if (nearest == nullptr) return {};
  const dvec3 p = origin + furthest * direction;
  const Surface at = surface(*nearest, p);
  const auto rise = [&](dvec3 step) {
    return surface(*nearest, p + step).distance - surface(*nearest, p - step).distance;
  };
  const double e = 0.0008 * furthest + 0.004;  // about half a pixel
  const dvec3 slope(rise({e, 0, 0}), rise({0, e, 0}), rise({0, 0, e}));
  return {furthest, glm::normalize(slope + dvec3(0, 1e-12, 0)), at.albedo, at.sky};
}

double Objects::sunlight(glm::dvec3 point, glm::dvec3 sun) const {
  double light = 1;
  visit_along(point, sun, [&](const Object& object, double from, double to) {
    for (double t = std::max(from, 0.05); t < to && light > 0;) {
      const double distance = surface(object, point + t * sun).distance;
      light = std::min(light, 0.5 + 0.5 * distance / (0.012 * t + 0.004));  // the sun is not a point
      t += std::max(std::abs(distance), 0.04);
    }
  });
  return std::max(light, 0.0);
}

}  // namespace texel::assets
