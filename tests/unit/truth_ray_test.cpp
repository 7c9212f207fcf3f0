// SPDX-License-Identifier: MIT
#include "truth/ray.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "../support/oracles.hpp"

namespace texel::truth {
namespace {

using glm::dvec2;
using glm::dvec3;
using test::angle;
using test::difference;
using test::number;
using MaybeHit = std::optional<Hit>;

/// A ray from somewhere around the origin to somewhere near it.
Ray ray(int i) {
  const dvec3 from = 4.0 * (dvec3(number(i, 0), number(i, 1), number(i, 2)) - 0.5);
  const dvec3 to = 2.4 * (dvec3(number(i, 3), number(i, 4), number(i, 5)) - 0.5);
  return {from, 3.0 * (to - from)};
}

double cube_distance(dvec3 p) {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}) - 0.8;
}
auto torus_distance(double minor) {
  return [=](dvec3 p) { return std::hypot(std::hypot(p.x, p.z) - 1, p.y) - minor; };
}

TEST(TruthRay, first_hit_lies_on_the_surface_at_its_texture_coordinate) {
  struct Row {
    const char* name;
    std::function<MaybeHit(const Ray&)> hit;
    std::function<double(dvec3)> distance;  // from the surface, negative inside
    std::function<Surface(const Hit&)> surface;
    double tolerance;  // a few roundings of coordinates up to 4
    int least_hits;
  };
  const auto torus_row = [](const char* name, double minor, int least_hits) {
    return Row{name,
               [=](const Ray& r) { return hit_torus(r, 1, minor); },
               torus_distance(minor),
               [=](const Hit&) { return torus(1, minor); },
               4e-15,  // measured 9e-16, and 1.8e-15 from the point at the texture coordinate
               least_hits};
  };
  const Row rows[] = {
      {"sphere", [](const Ray& r) { return hit_sphere(r, 0.8); },
       [](dvec3 p) { return glm::length(p) - 0.8; }, [](const Hit&) { return sphere(0.8); }, 2e-15, 300},
      {"cube", [](const Ray& r) { return hit_cube(r, 0.8); }, cube_distance,
       [](const Hit& hit) { return cube_face(hit.face, 0.8); }, 2e-15, 300},
      torus_row("thin torus", 0.05, 80),
      torus_row("torus", 0.4, 400),
      torus_row("thick torus", 0.95, 400)};
  for (const Row& row : rows) {
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
      SCOPED_TRACE(testing::Message() << row.name << ", ray " << i);
      const Ray r = ray(i);
      const MaybeHit hit = row.hit(r);
      // It is the first change from outside to inside or back along the ray, as 2000 steps show.
      const double end = hit ? hit->distance : 8 / glm::length(r.direction);
      const bool inside = row.distance(r.origin) < 0;
      for (int step = 1; step < 2000; ++step) {
        const double d = row.distance(r.origin + (end * step / 2000) * r.direction);
        // Steps that come closer to the surface than rounding cannot be told apart from touching it.
        ASSERT_TRUE(std::abs(d) < 1e-9 || (d < 0) == inside) << "step " << step;
      }
      if (!hit) continue;
      ++hits;
      const dvec3 position = r.origin + hit->distance * r.direction;
      EXPECT_GT(hit->distance, 0);
      EXPECT_LT(std::abs(row.distance(position)), row.tolerance);
      EXPECT_LT(glm::distance(row.surface(*hit)(hit->texcoord).position, position), 4 * row.tolerance);
    }
    EXPECT_GT(hits, row.least_hits) << row.name;
  }
}

TEST(TruthRay, hits_where_algebra_says_or_not_at_all) {
  const auto quad_hit = [](const Ray& r) { return hit_quad(r, 0.7); };
  const auto ring_hit = [](const Ray& r) { return hit_torus(r, 1, 0.4); };
  const std::tuple<const char*, MaybeHit, std::optional<double>> rows[] = {
      {"square", quad_hit({{0.35, -0.7, 2}, {0, 0, -1}}), 2},
      {"square from behind", quad_hit({{0, 0, -2}, {0.1, 0, 1}}), 2},
      {"beside it", quad_hit({{0.71, 0, 2}, {0, 0, -1}}), {}},
      {"away from it", quad_hit({{0, 0, 2}, {0, 0, 1}}), {}},
      {"parallel", quad_hit({{0, 0, 2}, {1, 0, 0}}), {}},
      {"within its plane", quad_hit({{0, 0, 0}, {1, 0, 0}}), {}},
      {"beside the sphere", hit_sphere({{0, 2, 3}, {0, 0, -1}}), {}},
      {"away from it", hit_sphere({{0, 0, 3}, {0, 0, 1}}), {}},
      {"beside the cube", hit_cube({{0, 2, 3}, {0, 0, -1}}), {}},
      {"away from it", hit_cube({{0, 0, 3}, {0, 0, 1}}), {}},
      {"torus", ring_hit({{0, 0, 2.5}, {0, 0, -1}}), 2.5 - 1.4},
      {"from the hole", ring_hit({{0, 0, 0}, {-2, 0, 0}}), (1 - 0.4) / 2},
      {"from inside the tube", ring_hit({{1, 0, 0}, {0, 1, 0}}), 0.4},
      {"from above the tube", ring_hit({{1, 2, 0}, {0, -1, 0}}), 1.6},
      {"through the hole", ring_hit({{0, 3, 0}, {0, -1, 0}}), {}},
      {"away from it", ring_hit({{0, 0, 3}, {0, 0, 1}}), {}},
      {"over the top", ring_hit({{0, 0.41, 3}, {0, 0, -1}}), {}},
  };
  for (const auto& [name, hit, distance] : rows) {
    ASSERT_EQ(hit.has_value(), distance.has_value()) << name;
    if (hit) {
      EXPECT_NEAR(hit->distance, *distance, 1e-15) << name;  // roundings of lengths up to 3
    }
  }
  EXPECT_LT(glm::distance(quad_hit({{0.35, -0.7, 2}, {0, 0, -1}})->texcoord, dvec2(0.75, 0)), 1e-16);
  // An edge of the cube belongs to the first axis.
  EXPECT_EQ(hit_cube({{2, 2, 0.25}, {-1, -1, 0}})->face, image::Face::positive_x);
  EXPECT_EQ(hit_cube({{0.25, -2, -2}, {0, 1, 1}})->face, image::Face::negative_y);
  EXPECT_EQ(hit_cube({{0, 0, 0}, {-1, 1, 1}})->face, image::Face::negative_x) << "a corner from inside";
}

TEST(TruthRay, torus_is_hit_by_rays_that_only_just_cross_it) {
  for (const double depth : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const auto hit = hit_torus({{0, 0.4 - depth, 3}, {0, 0, -1}}, 1, 0.4);
    ASSERT_TRUE(hit) << depth;
    // Where the tube is that much lower than its top; a rounding of the height counts by the root's slope.
    EXPECT_NEAR(hit->distance, 2 - std::sqrt(depth * (0.8 - depth)), 2e-16 / std::sqrt(depth));
    EXPECT_FALSE(hit_torus({{0, 0.4 + depth, 3}, {0, 0, -1}}, 1, 0.4)) << depth;
  }
}

TEST(TruthRay, size_of_the_world_is_only_a_factor) {
  for (const double size : {1e-6, 1e6})
    for (int i = 0; i < 200; ++i) {
      const Ray r = ray(i);
      const auto a = hit_torus(r, 1, 0.4), b = hit_torus({size * r.origin, r.direction}, size, 0.4 * size);
      ASSERT_EQ(a.has_value(), b.has_value());
      // Rounding of the sizes moves a grazing hit by its root: measured 6e-14.
      if (a) {
        EXPECT_NEAR(b->distance / (size * a->distance), 1, 2e-12);
      }
    }
}

TEST(TruthRay, sphere_is_hit_where_the_ray_aims_from_itself_and_from_far_away) {
  for (int i = 1; i < 200; ++i) {  // from the sphere itself; rounding puts the eye now inside and now outside
    const dvec3 eye = glm::normalize(dvec3(std::sin(i), std::cos(3.0 * i), std::sin(2.0 * i)));
    const dvec3 target = glm::normalize(dvec3(std::cos(i), std::sin(5.0 * i), std::cos(2.0 * i)));
    const auto hit = hit_sphere({eye, glm::normalize(target - eye)});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, glm::distance(eye, target), 1e-14) << i;
  }
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

TEST(TruthCamera, looks_at_the_origin_from_where_its_angles_say_and_the_height_spans_the_field_of_view) {
  // 2 sin and cos of 30 and 60 degrees; a rounding of the distance.
  const Camera turned{.yaw = 60, .pitch = 30, .distance = 2, .width = 640, .height = 480};
  EXPECT_LT(glm::distance(turned.eye(), dvec3(1.5, 1, std::sqrt(0.75))), 1e-15);
  EXPECT_LT(angle(pixel_ray(turned, {320, 240}).ray.direction, -turned.eye()), 1e-15);
  EXPECT_EQ(pixel_ray(turned, {320, 240}).ray.origin, turned.eye());

  const Camera camera{.distance = 5, .field_of_view = 50, .width = 640, .height = 480};
  const auto direction = [&](double x, double y) { return pixel_ray(camera, {x, y}).ray.direction; };
  EXPECT_NEAR(test::angle_in_degrees(direction(320, 0), direction(320, 480)), 50, 1e-13);
  EXPECT_GT(direction(320, 480).y, 0.0) << "window y runs up";
  EXPECT_GT(direction(640, 240).x, 0.0) << "and x to the right";
  // To the side, the tangent is as much larger as the picture is wider than high.
  EXPECT_NEAR(std::tan(angle(direction(640, 240), direction(320, 240))),
              640.0 / 480 * std::tan(glm::radians(25.0)), 1e-15);
}

TEST(TruthGradient, texcoord_changes_from_pixel_to_pixel_as_rays_beside_it_show) {
  const Camera camera{.yaw = 25, .pitch = 35, .distance = 3.5, .width = 128, .height = 128};
  const Placement placement{{dvec3(1, 0, 0.2), dvec3(0, 1.3, 0), dvec3(0, 0.1, 0.9)}, {0.1, 0, 0}};
  const Surface surface = placed(torus(1, 0.4), placement);
  constexpr double step = 1e-5;
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const dvec2 window(128 * number(i, 0), 128 * number(i, 1));
    const auto hit = [&](double x, double y) {
      return hit_torus(object_ray(ray_through(camera, window + dvec2(x, y)), placement), 1, 0.4);
    };
    const auto here = hit(0, 0);
    if (!here || !hit(step, 0) || !hit(-step, 0) || !hit(0, step) || !hit(0, -step)) continue;
    const SurfacePoint point = surface(here->texcoord);
    const PixelRay pixel = pixel_ray(camera, window);
    // The object's ray meets it at the world's distance.
    EXPECT_LT(glm::distance(point.position, pixel.ray.origin + here->distance * pixel.ray.direction), 2e-14);
    if (std::abs(glm::dot(point.normal, pixel.ray.direction)) < 0.1) continue;  // grazing: differences fail
    // Texture coordinates as they go on from here, across a seam too.
    const auto texcoord = [&](double x, double y) {
      const dvec2 d = hit(x, y)->texcoord - here->texcoord;
      return d - glm::round(d);
    };
    const auto position = [&](double x) { return surface(hit(x, 0)->texcoord).position; };
    const TexcoordGradient gradient = texcoord_gradient(pixel, point);
    // Rounding, 2e-16 / 1e-5, and the growth of the curvature towards the rim. Gradients are about 0.005.
    const dvec2 by_x = difference(step, [&](double x) { return texcoord(x, 0); });
    const dvec2 by_y = difference(step, [&](double y) { return texcoord(0, y); });
    EXPECT_LT(glm::distance(gradient.dx, by_x), 2e-10);
    EXPECT_LT(glm::distance(gradient.dy, by_y), 2e-10);
    EXPECT_LT(glm::distance(position_gradient(pixel, point).dx, difference(step, position)), 2e-9);
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST(TruthGradient, follows_the_texture_coordinates_when_they_are_sheared_or_stretched) {
  const PixelRay pixel = pixel_ray({.yaw = 10, .pitch = 40}, {260, 250});
  const auto hit = hit_quad(pixel.ray);
  ASSERT_TRUE(hit);
  const TexcoordGradient plain = texcoord_gradient(pixel, quad()(hit->texcoord));
  for (const TexcoordMap& map : {test::sheared(0.7), test::stretched(4), test::mirrored()}) {
    const TexcoordGradient other =
        texcoord_gradient(pixel, reparameterized(quad(), map)(map.texcoord(hit->texcoord)));
    EXPECT_LT(glm::distance(other.dx, map.linear * plain.dx), 1e-16);  // both about 0.003
    EXPECT_LT(glm::distance(other.dy, map.linear * plain.dy), 1e-16);
  }
}

}  // namespace
}  // namespace texel::truth
