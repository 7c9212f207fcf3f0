// SPDX-License-Identifier: MIT
#include "truth/optics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "../support/oracles.hpp"
#include "procedural/noise.hpp"

namespace texel::truth {
namespace {

using glm::dvec2;
using glm::dvec3;
using std::numbers::pi;
using test::angle;
using test::angle_in_degrees;
using test::fresnel;

dvec3 unit(int i) {
  return sphere()({procedural::random(i, 0, 17), procedural::random(i, 1, 17)}).position;
}

TEST(TruthOptics, reflecting_twice_changes_nothing_and_angles_are_equal) {
  for (int i = 0; i < 500; ++i) {
    const dvec3 incident = unit(i), normal = unit(i + 1000);
    const dvec3 out = reflected(incident, normal);
    EXPECT_LT(glm::distance(reflected(out, normal), incident), 2e-15);  // a few roundings
    EXPECT_NEAR(angle(out, normal), angle(-incident, normal), 2e-15);
    EXPECT_LT(std::abs(glm::dot(glm::cross(incident, normal), out)), 1e-15) << "in one plane";
    EXPECT_LT(glm::distance(reflected(incident, -normal), out), 1e-15);
  }
}

TEST(TruthOptics, refraction_obeys_snell_stays_in_the_plane_and_can_be_reversed) {
  for (const auto& [n_from, n_to] : {std::pair{1.0, 1.5}, {1.0, 2.42}, {1.33, 1.0}, {1.5, 1.0}, {1.2, 1.2}})
    for (int i = 0; i < 500; ++i) {
      const dvec3 incident = unit(i), normal = unit(i + 1000);
      const auto out = refracted(incident, normal, n_from, n_to);
      const double sin_from = glm::length(glm::cross(incident, normal));
      ASSERT_EQ(out.has_value(), n_from * sin_from <= n_to);
      if (!out) continue;
      EXPECT_NEAR(glm::length(*out), 1, 1e-15);
      EXPECT_NEAR(n_from * sin_from, n_to * glm::length(glm::cross(*out, normal)), 2e-15);
      EXPECT_GT(glm::dot(incident, normal) * glm::dot(*out, normal), 0) << "it goes on";
      const auto back = refracted(-*out, normal, n_to, n_from);
      ASSERT_TRUE(back);
      // The cosine comes from the sine, so a rounding counts by their ratio at grazing incidence: measured
      // 2e-15.
      EXPECT_LT(glm::distance(*back, -incident) * std::abs(glm::dot(incident, normal)), 6e-15);
    }
}

TEST(TruthOptics, total_internal_reflection_begins_at_the_critical_angle) {
  const double critical = std::asin(1 / 1.5);
  const auto at = [](double a) { return dvec3(std::sin(a), -std::cos(a), 0); };
  EXPECT_TRUE(refracted(at(critical - 1e-12), {0, 1, 0}, 1.5, 1.0));
  EXPECT_FALSE(refracted(at(critical + 1e-12), {0, 1, 0}, 1.5, 1.0));
  EXPECT_LT(fresnel(std::cos(critical - 1e-3), 1.5, 1.0), 0.9);
  EXPECT_EQ(fresnel(std::cos(critical + 1e-12), 1.5, 1.0), 1.0);
  EXPECT_TRUE(refracted(at(1.57), {0, 1, 0}, 1.0, 1.5)) << "never from the thin side";
}

TEST(TruthOptics, fresnel_is_the_same_from_both_sides_and_keeps_the_energy) {
  for (int i = 1; i < 1000; ++i) {
    const double a = 0.5 * pi * i / 1000, b = std::asin(std::sin(a) / 1.5);
    const double R = fresnel(std::cos(a), 1, 1.5);
    // Near the critical angle b, a rounding of its cosine counts by 1 / cos(a): measured 1e-15.
    EXPECT_LT(std::abs(R - fresnel(std::cos(b), 1.5, 1)) * std::cos(a), 4e-15);
    // What goes through by Fresnel's transmission coefficients (Born and Wolf, equations 21 and 35-36).
    const double factor = 1.5 * std::cos(b) / std::cos(a);
    const double across = 2 * std::cos(a) / (std::cos(a) + 1.5 * std::cos(b));
    const double within = 2 * std::cos(a) / (1.5 * std::cos(a) + std::cos(b));
    const double T = 0.5 * factor * (across * across + within * within);
    EXPECT_NEAR(R + T, 1, 2e-15);  // measured 4.4e-16
  }
}

TEST(TruthOptics, change_of_the_mirrored_ray_is_what_rays_beside_it_show) {
  const Camera camera{.yaw = 30, .pitch = 15, .distance = 6, .width = 128, .height = 128};
  const Placement ellipsoid{{dvec3(2, 0, 0), dvec3(0.2, 0.5, 0), dvec3(0, 0, 1)}, {0.1, 0.2, 0}};
  constexpr double step = 1e-4;
  int compared = 0;
  for (int i = 0; i < 400; ++i) {
    const dvec2 window(128 * procedural::random(i, 0, 1), 128 * procedural::random(i, 1, 1));
    const auto at = [&](dvec2 offset) { return mirror_point(pixel_ray(camera, window + offset), ellipsoid); };
    const auto here = at({0, 0}), right = at({step, 0}), left = at({-step, 0}), above = at({0, step}),
               below = at({0, -step});
    if (!here || !right || !left || !above || !below) continue;
    if (glm::dot(here->incident, here->surface.normal) > -0.1) continue;  // near the rim differences fail
    // Measured: 3e-9, where the curvature is largest, towards the rim.
    EXPECT_LT(glm::distance(here->reflected_change.dx, (right->reflected - left->reflected) / (2 * step)),
              1e-8);
    EXPECT_LT(glm::distance(here->reflected_change.dy, (above->reflected - below->reflected) / (2 * step)),
              1e-8);
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

TEST(TruthOptics, mirrored_ray_and_incident_ray_meet_at_the_surface_under_equal_angles) {
  const Camera camera{.yaw = 200, .pitch = -20, .distance = 4, .width = 64, .height = 64};
  int hits = 0;
  for (const Placement& placement :
       {Placement{}, Placement{{dvec3(4, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)}}})
    for (int i = 0; i < 300; ++i) {
      const dvec2 window(64 * procedural::random(i, 0, 2), 64 * procedural::random(i, 1, 2));
      const auto mirror = mirror_point(pixel_ray(camera, window), placement);
      if (!mirror) continue;
      ++hits;
      EXPECT_LT(angle(mirror->surface.position - camera.eye(), mirror->incident), 4e-15);
      EXPECT_LT(glm::dot(mirror->incident, mirror->surface.normal), 0.0);
      EXPECT_NEAR(angle(mirror->reflected, mirror->surface.normal),
                  angle(-mirror->incident, mirror->surface.normal), 4e-15);
    }
  EXPECT_GT(hits, 100);
}

TEST(TruthOptics, constant_incident_ray_is_off_by_what_the_worksheets_sphere_shows) {
  // Mirroring keeps angles, so taking the ray from the eye to the centre for every point is wrong by the
  // angle between the two incident rays. Unit sphere, eye at 4: at most asin(1 / 4) at the rim.
  const Camera camera{.distance = 4, .field_of_view = 35, .width = 512, .height = 512};
  const dvec3 constant = -camera.eye();
  double sum = 0, area_sum = 0, area = 0, largest = 0;
  int pixels = 0;
  for (int y = 0; y < 512; ++y)
    for (int x = 0; x < 512; ++x) {
      const PixelRay pixel = pixel_ray(camera, dvec2(x, y) + 0.5);
      const auto mirror = mirror_point(pixel);
      if (!mirror) continue;
      const double off = angle_in_degrees(reflected(constant, mirror->surface.normal), mirror->reflected);
      const PositionGradient position = position_gradient(pixel, mirror->surface);
      const double covered = glm::length(glm::cross(position.dx, position.dy));
      sum += off;
      area_sum += off * covered;
      area += covered;
      largest = std::max(largest, off);
      ++pixels;
    }
  EXPECT_NEAR(sum / pixels, 9.73, 0.02);  // by hand: (2/3 r - 2/15 r^3) radians with r = tan(asin(1/4))
  EXPECT_NEAR(area_sum / area, 11.8, 0.05);
  // The cap that an eye at 4 sees: 2 pi (1 - 1/4). Pixels at the rim cover it unevenly.
  EXPECT_NEAR(area, 2 * pi * 0.75, 0.02);
  EXPECT_NEAR(largest, std::asin(0.25) * 180 / pi, 0.02);
}

}  // namespace
}  // namespace texel::truth
