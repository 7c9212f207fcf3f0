// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>

#include "truth/ray.hpp"

namespace texel::truth {

using glm::dvec3;

namespace {

/// A polynomial's value and derivative at t; the coefficient of t^i is c[i].
struct Value {
  double value = 0, derivative = 0;
};
Value evaluate(std::span<const double> c, double t) {
  Value result;
  for (std::size_t i = c.size(); i-- > 0;) {
    result.derivative = result.derivative * t + result.value;
    result.value = result.value * t + c[i];
  }
  return result;
}

/// The root between low and high, where the polynomial has different signs: Newton's steps as long as they
/// stay between the ends, else halving.
double root_between(std::span<const double> c, double low, double high) {
  const bool rising = evaluate(c, low).value < 0;
  double t = 0.5 * (low + high);
  for (int step = 0; step < 200; ++step) {  // Newton takes about 8; this many halvings leave nothing
    const Value here = evaluate(c, t);
    ((here.value < 0) == rising ? low : high) = t;
    double next = t - here.value / here.derivative;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (next == t || next == low || next == high) break;
    t = next;
  }
  return t;
}

/// Up to six numbers in a row, without the cost of memory for each ray.
struct Few {
  std::array<double, 6> values{};
  std::size_t count = 0;

  void add(double value) { values[count++] = value; }
  [[nodiscard]] std::span<const double> all() const { return std::span(values).first(count); }
};

/// Where the polynomial changes its sign between low and high, from the lowest up, `most` times at the most.
/// Its degree is 4 at most, and it has no cubic term. Between two neighbouring roots of its derivative it
/// changes its sign once at most.
Few sign_changes(std::span<const double> c, double low, double high, std::size_t most = 4) {
  Few roots, ends;
  if (c.size() == 3) {                            // the second derivative of such a quartic: c[0] + c[2] t^2
    const double root = std::sqrt(-c[0] / c[2]);  // NaN: none
    for (const double t : {-root, root})
      if (t > low && t < high) roots.add(t);
    return roots;
  }
  Few derivative;
  for (std::size_t i = 1; i < c.size(); ++i) derivative.add(static_cast<double>(i) * c[i]);
  ends = sign_changes(derivative.all(), low, high);
  ends.add(high);
  for (double begin = low; const double end : ends.all()) {
    if (roots.count < most && (evaluate(c, begin).value < 0) != (evaluate(c, end).value < 0))
      roots.add(root_between(c, begin, end));
    begin = end;
  }
  return roots;
}

/// Distance from the torus, negative inside, and its gradient.
struct Distance {
  double value;
  dvec3 gradient;
};
Distance torus_distance(dvec3 p, double major, double minor) {
  const double from_axis = std::hypot(p.x, p.z);
  const dvec3 outward(p.x / from_axis, 0, p.z / from_axis);
  const double from_tube = std::hypot(from_axis - major, p.y);
  return {from_tube - minor, ((from_axis - major) * outward + dvec3(0, p.y, 0)) / from_tube};
}

}  // namespace

std::optional<Hit> hit_torus(const Ray& ray, double major, double minor) {
  // Lengths in units of the torus's radius and from the point of the ray nearest to its centre, so that the
  // quartic's coefficients are of one size.
  const double size = major + minor, speed = glm::length(ray.direction) / size;
  const dvec3 d = glm::normalize(ray.direction);
  const double start = glm::dot(ray.origin, d) / size;
  const dvec3 o = ray.origin / size - start * d;
  const double reach = 1 - glm::dot(o, o);
  if (reach <= 0) return std::nullopt;
  const double R = major / size, r = minor / size;

  // (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2) with p = o + t d and o . d = 0.
  const double k = glm::dot(o, o) + R * R - r * r;
  const double coefficients[] = {k * k - 4 * R * R * (o.x * o.x + o.z * o.z),
                                 -8 * R * R * (o.x * d.x + o.z * d.z),
                                 2 * k - 4 * R * R * (d.x * d.x + d.z * d.z), 0, 1};
  // A little beyond the sphere around the torus, so that a root on it is still between signs.
  const double far = 1.0001 * std::sqrt(reach) + 1e-9;
  if (start >= far) return std::nullopt;  // it looks away
  const Few roots = sign_changes(coefficients, std::max(start, -far), far, 1);
  if (roots.count == 0) return std::nullopt;

  double t = roots.values.front();
  Distance here = torus_distance(o + t * d, R, r);
  for (int step = 0; step < 4; ++step) {
    const double next = t - here.value / glm::dot(here.gradient, d);
    const Distance there = torus_distance(o + next * d, R, r);
    if (!(std::abs(there.value) < std::abs(here.value))) break;
    t = next;
    here = there;
  }
  return Hit{.distance = (t - start) / speed, .texcoord = torus_texcoord(o + t * d, R)};
}

}  // namespace texel::truth
