// SPDX-License-Identifier: MIT
#include "truth/ray.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>

#include "../support/numbers.hpp"
#include "../support/oracles.hpp"

namespace texel::truth {
namespace {

using glm::dvec2;
using glm::dvec3;
using test::angle;
using test::angle_in_degrees;
using test::mirrored;
using test::number;
using test::sheared;
using test::stretched;

/// A ray from somewhere around the origin to somewhere near it.
Ray ray(int i) {
  const dvec3 from = 4.0 * (dvec3(number(i, 0), number(i, 1), number(i, 2)) - 0.5);
  const dvec3 to = 2.4 * (dvec3(number(i, 3), number(i, 4), number(i, 5)) - 0.5);
  return {from, 3.0 * (to - from)};
}

double torus_distance(dvec3 p, double major, double minor) {
  return std::hypot(std::hypot(p.x, p.z) - major, p.y) - minor;
}
double cube_distance(dvec3 p, double half_size) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - half_size;
}

/// What every hit must be: on the surface, at its texture coordinate, and the first change from outside to
/// inside or back along the ray, as 2000 steps show. Returns the number of hits.
int expect_first_hits(const std::function<std::optional<Hit>(const Ray&)>& hit_of,
                      const std::function<double(dvec3)>& distance,
                      const std::function<dvec3(const Hit&)>& at, double tolerance) {
  constexpr int rays = 1000, steps = 2000;
  int hits = 0;
  for (int i = 0; i < rays; ++i) {
    const Ray r = ray(i);
    const auto hit = hit_of(r);
    hits += hit ? 1 : 0;
    const double end = hit ? hit->distance : 8 / glm::length(r.direction);
    const bool inside = distance(r.origin) < 0;
    // Steps that come closer to the surface than rounding cannot be told apart from touching it.
    for (int step = 1; step < steps; ++step) {
      const double d = distance(r.origin + (end * step / steps) * r.direction);
      EXPECT_TRUE(std::abs(d) < 1e-9 || (d < 0) == inside) << "ray " << i << " step " << step;
    }
    if (!hit) continue;
    const dvec3 position = r.origin + hit->distance * r.direction;
    EXPECT_GT(hit->distance, 0);
    EXPECT_LT(std::abs(distance(position)), tolerance) << "ray " << i;
    EXPECT_LT(glm::distance(at(*hit), position), 4 * tolerance) << "ray " << i;
  }
  return hits;
}

TEST(TruthRay, first_hit_of_a_sphere_lies_on_it) {
  const int hits = expect_first_hits([](const Ray& r) { return hit_sphere(r, 0.8); },
                                     [](dvec3 p) { return glm::length(p) - 0.8; },
                                     [](const Hit& hit) { return sphere(0.8)(hit.texcoord).position; },
                                     2e-15);  // a few roundings of coordinates up to 4
  EXPECT_GT(hits, 300);
}

TEST(TruthRay, from_a_sphere_itself_the_far_side_is_seen) {
  for (int i = 1; i < 200; ++i) {  // rounding puts the eye now inside and now outside
    const dvec3 eye = glm::normalize(dvec3(std::sin(i), std::cos(3.0 * i), std::sin(2.0 * i)));
    const dvec3 target = glm::normalize(dvec3(std::cos(i), std::sin(5.0 * i), std::cos(2.0 * i)));
    const auto hit = hit_sphere({eye, glm::normalize(target - eye)});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, glm::distance(eye, target), 1e-14) << i;
  }
}

TEST(TruthRay, first_hit_of_a_cube_lies_on_it) {
  const int hits = expect_first_hits(
      [](const Ray& r) { return hit_cube(r, 0.8); }, [](dvec3 p) { return cube_distance(p, 0.8); },
      [](const Hit& hit) { return cube_face(hit.face, 0.8)(hit.texcoord).position; }, 2e-15);
  EXPECT_GT(hits, 300);
}

TEST(TruthRay, first_hit_of_a_torus_lies_on_it) {
  for (const double minor : {0.05, 0.4, 0.95}) {
    const int hits =
        expect_first_hits([=](const Ray& r) { return hit_torus(r, 1, minor); },
                          [=](dvec3 p) { return torus_distance(p, 1, minor); },
                          [=](const Hit& hit) { return torus(1, minor)(hit.texcoord).position; },
                          4e-15);  // measured 9e-16, and 1.8e-15 from the point at the texture coordinate
    EXPECT_GT(hits, minor < 0.1 ? 80 : 400) << minor;
  }
}

TEST(TruthRay, edge_of_a_cube_belongs_to_the_first_axis) {
  EXPECT_EQ(hit_cube({{2, 2, 0.25}, {-1, -1, 0}})->face, procedural::Face::positive_x);
  EXPECT_EQ(hit_cube({{0.25, -2, -2}, {0, 1, 1}})->face, procedural::Face::negative_y);
  EXPECT_EQ(hit_cube({{0, 0, 0}, {-1, 1, 1}})->face, procedural::Face::negative_x) << "a corner from inside";
}

TEST(TruthRay, quad_is_hit_from_both_sides_and_not_beside_or_behind) {
  const auto hit = hit_quad({{0.35, -0.7, 2}, {0, 0, -1}}, 0.7);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->distance, 2.0);
  EXPECT_NEAR(hit->texcoord.s, 0.75, 1e-16);
  EXPECT_EQ(hit->texcoord.t, 0.0);
  EXPECT_TRUE(hit_quad({{0, 0, -2}, {0.1, 0, 1}}, 0.7));
  EXPECT_FALSE(hit_quad({{0.71, 0, 2}, {0, 0, -1}}, 0.7));
  EXPECT_FALSE(hit_quad({{0, 0, 2}, {0, 0, 1}}, 0.7));
  EXPECT_FALSE(hit_quad({{0, 0, 2}, {1, 0, 0}}, 0.7)) << "parallel";
  EXPECT_FALSE(hit_quad({{0, 0, 0}, {1, 0, 0}}, 0.7)) << "within its plane";
}

TEST(TruthRay, rays_that_pass_or_look_away_hit_nothing) {
  EXPECT_FALSE(hit_sphere({{0, 2, 3}, {0, 0, -1}}));
  EXPECT_FALSE(hit_sphere({{0, 0, 3}, {0, 0, 1}}));
  EXPECT_FALSE(hit_cube({{0, 2, 3}, {0, 0, -1}}));
  EXPECT_FALSE(hit_cube({{0, 0, 3}, {0, 0, 1}}));
  EXPECT_FALSE(hit_torus({{0, 3, 0}, {0, -1, 0}}, 1, 0.4)) << "through the hole";
  EXPECT_FALSE(hit_torus({{0, 0, 3}, {0, 0, 1}}, 1, 0.4));
  EXPECT_FALSE(hit_torus({{0, 0.41, 3}, {0, 0, -1}}, 1, 0.4)) << "over the top";
}

TEST(TruthRay, torus_is_hit_along_its_axes_where_algebra_says) {
  // (2.5 - 1.4) and from the hole (1 - 0.4); roundings of lengths up to 3.
  EXPECT_NEAR(hit_torus({{0, 0, 2.5}, {0, 0, -1}}, 1, 0.4)->distance, 1.1, 1e-15);
  EXPECT_NEAR(hit_torus({{0, 0, 0}, {-2, 0, 0}}, 1, 0.4)->distance, 0.3, 1e-15);
  EXPECT_NEAR(hit_torus({{1, 0, 0}, {0, 1, 0}}, 1, 0.4)->distance, 0.4, 1e-15) << "from inside the tube";
  EXPECT_NEAR(hit_torus({{1, 2, 0}, {0, -1, 0}}, 1, 0.4)->distance, 1.6, 1e-15);
}

TEST(TruthRay, torus_is_hit_by_rays_that_only_just_cross_it) {
  for (const double depth : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const Ray over_the_top{{0, 0.4 - depth, 3}, {0, 0, -1}};
    const auto hit = hit_torus(over_the_top, 1, 0.4);
    ASSERT_TRUE(hit) << depth;
    // Where the tube is that much lower than its top; a rounding of the height counts by the root's slope.
    EXPECT_NEAR(hit->distance, 2 - std::sqrt(depth * (0.8 - depth)), 2e-16 / std::sqrt(depth));
    EXPECT_FALSE(hit_torus({{0, 0.4 + depth, 3}, {0, 0, -1}}, 1, 0.4)) << depth;
  }
}

TEST(TruthRay, torus_is_hit_by_rays_that_meet_it_four_times_at_the_first) {
  for (int i = 0; i < 200; ++i) {
    const double height = 0.3 * (2 * number(i, 0) - 1), side = 0.4 * (2 * number(i, 1) - 1);
    const auto hit = hit_torus({{side, height, 5}, {0, 0, -1}}, 1, 0.4);
    ASSERT_TRUE(hit);
    const double tube = 1 + std::sqrt(0.16 - height * height);
    EXPECT_NEAR(hit->distance, 5 - std::sqrt(tube * tube - side * side), 4e-15);  // roundings of 5
  }
}

TEST(TruthRay, size_of_the_world_is_only_a_factor) {
  for (const double size : {1e-6, 1e6})
    for (int i = 0; i < 200; ++i) {
      const Ray r = ray(i), big{size * r.origin, r.direction};
      const auto a = hit_torus(r, 1, 0.4), b = hit_torus(big, size, 0.4 * size);
      ASSERT_EQ(a.has_value(), b.has_value());
      // Rounding of the sizes moves a grazing hit by its root: measured 6e-14.
      if (a) {
        EXPECT_NEAR(b->distance / (size * a->distance), 1, 2e-12);
      }
    }
}

TEST(TruthRay, small_sphere_far_away_keeps_its_digits) {
  const dvec3 eye(0, 3e5, 1e6);
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const dvec3 target = sphere()({number(i, 0), number(i, 1)}).position;
    if (glm::dot(target, glm::normalize(eye)) < 0.2) continue;  // on the far side
    const auto hit = hit_sphere({eye, glm::normalize(target - eye)});
    ASSERT_TRUE(hit);
    // The direction is rounded to 1e-16 of 1e6 units, and a slanted surface shows that up to 5 times as long.
    EXPECT_LT(glm::distance(sphere()(hit->texcoord).position, target), 2e-9);
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST(TruthRay, object_ray_meets_the_object_at_the_worlds_distance) {
  const Placement ellipsoid{{dvec3(4, 0, 0), dvec3(0.3, 1, 0), dvec3(0, 0, 0.5)}, {0.5, 0.2, -1}};
  const Surface surface = placed(sphere(), ellipsoid);
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    const Ray r = ray(i);
    const auto hit = hit_sphere(object_ray(r, ellipsoid));
    if (!hit) continue;
    ++hits;
    // Through the inverse and back: the axes' ratio of 8 times a few roundings.
    EXPECT_LT(glm::distance(surface(hit->texcoord).position, r.origin + hit->distance * r.direction), 2e-14);
  }
  EXPECT_GT(hits, 100);
}

TEST(TruthCamera, looks_at_the_origin_from_where_its_angles_say) {
  // 2 sin and cos of 30 and 60 degrees; a rounding of the distance.
  const Camera camera{.yaw = 60, .pitch = 30, .distance = 2, .width = 640, .height = 480};
  EXPECT_LT(glm::distance(camera.eye(), dvec3(1.5, 1, std::sqrt(0.75))), 1e-15);
  const PixelRay middle = pixel_ray(camera, {320, 240});
  EXPECT_LT(angle(middle.ray.direction, -camera.eye()), 1e-15);
  EXPECT_EQ(middle.ray.origin, camera.eye());
}

TEST(TruthCamera, window_x_runs_right_and_y_up_and_the_height_spans_the_field_of_view) {
  const Camera camera{.distance = 5, .field_of_view = 50, .width = 640, .height = 480};
  const dvec3 bottom = pixel_ray(camera, {320, 0}).ray.direction;
  const dvec3 top = pixel_ray(camera, {320, 480}).ray.direction;
  EXPECT_NEAR(angle_in_degrees(bottom, top), 50, 1e-13);
  EXPECT_GT(top.y, 0.0);
  EXPECT_GT(pixel_ray(camera, {640, 240}).ray.direction.x, 0.0);
  // A pixel is as wide as it is high.
  EXPECT_NEAR(glm::length(pixel_ray(camera, {320, 240}).dx), glm::length(pixel_ray(camera, {320, 240}).dy),
              1e-18);
}

TEST(TruthCamera, change_of_the_ray_is_what_differences_show) {
  const Camera camera{.yaw = -130, .pitch = 55, .field_of_view = 120, .width = 64, .height = 48};
  constexpr double step = 1e-4;
  for (int i = 0; i < 100; ++i) {
    const dvec2 window(64 * number(i, 0), 48 * number(i, 1));
    const PixelRay pixel = pixel_ray(camera, window);
    const auto direction = [&](double dx, double dy) {
      return pixel_ray(camera, window + dvec2(dx, dy)).ray.direction;
    };
    // Rounding, 1e-16 / 1e-4, and the step squared times a pixel's angle of 0.07 cubed.
    EXPECT_LT(glm::distance(pixel.dx, (direction(step, 0) - direction(-step, 0)) / (2 * step)), 1e-11);
    EXPECT_LT(glm::distance(pixel.dy, (direction(0, step) - direction(0, -step)) / (2 * step)), 1e-11);
  }
}

TEST(TruthGradient, texcoord_changes_from_pixel_to_pixel_as_rays_beside_it_show) {
  const Camera camera{.yaw = 25, .pitch = 35, .distance = 3.5, .width = 128, .height = 128};
  const Placement placement{{dvec3(1, 0, 0.2), dvec3(0, 1.3, 0), dvec3(0, 0.1, 0.9)}, {0.1, 0, 0}};
  const Surface surface = placed(torus(1, 0.4), placement);
  constexpr double step = 1e-5;
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const dvec2 window(128 * number(i, 0), 128 * number(i, 1));
    const auto hit = [&](dvec2 w) {
      return hit_torus(object_ray(pixel_ray(camera, w).ray, placement), 1, 0.4);
    };
    const auto here = hit(window), right = hit(window + dvec2(step, 0)), left = hit(window - dvec2(step, 0)),
               above = hit(window + dvec2(0, step)), below = hit(window - dvec2(0, step));
    if (!here || !right || !left || !above || !below) continue;
    const SurfacePoint point = surface(here->texcoord);
    const PixelRay pixel = pixel_ray(camera, window);
    if (std::abs(glm::dot(point.normal, pixel.ray.direction)) < 0.1) continue;  // grazing: differences fail
    const auto wrapped = [](dvec2 d) { return d - glm::round(d); };
    const TexcoordGradient gradient = texcoord_gradient(pixel, point);
    // Rounding, 2e-16 / 1e-5, and the growth of the curvature towards the rim. Gradients are about 0.005.
    EXPECT_LT(glm::distance(gradient.dx, wrapped(right->texcoord - left->texcoord) / (2 * step)), 2e-10);
    EXPECT_LT(glm::distance(gradient.dy, wrapped(above->texcoord - below->texcoord) / (2 * step)), 2e-10);
    const PositionGradient position = position_gradient(pixel, point);
    EXPECT_LT(
        glm::distance(position.dx,
                      (surface(right->texcoord).position - surface(left->texcoord).position) / (2 * step)),
        2e-9);
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST(TruthGradient, follows_the_texture_coordinates_when_they_are_sheared_or_stretched) {
  const Camera camera{.yaw = 10, .pitch = 40};
  const PixelRay pixel = pixel_ray(camera, {260, 250});
  const auto hit = hit_quad(pixel.ray);
  ASSERT_TRUE(hit);
  const TexcoordGradient plain = texcoord_gradient(pixel, quad()(hit->texcoord));
  for (const TexcoordMap& map : {sheared(0.7), stretched(4), mirrored()}) {
    const TexcoordGradient other =
        texcoord_gradient(pixel, reparameterized(quad(), map)(map.texcoord(hit->texcoord)));
    EXPECT_LT(glm::distance(other.dx, map.linear * plain.dx), 1e-16);  // both about 0.003
    EXPECT_LT(glm::distance(other.dy, map.linear * plain.dy), 1e-16);
  }
}

}  // namespace
}  // namespace texel::truth
