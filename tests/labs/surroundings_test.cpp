// SPDX-License-Identifier: MIT
// What labs 6 to 9 show where two things meet: the faces of a cube map, spheres one behind the other, the
// edges of one picture for all directions.
#include <fmt/format.h>

#include <cmath>
#include <glm/glm.hpp>

#include "../../labs/07_environment/scene.hpp"
#include "../support/tolerance.hpp"
#include "image/color.hpp"
#include "image/load.hpp"
#include "labs.hpp"
#include "truth/ray.hpp"

namespace texel::test {
namespace {

using glm::dvec3;

TEST(GlassOfLab8, reflects_four_percent_where_one_looks_straight_at_it) {
  const TemporaryFolder folder("glass");
  std::vector<Shot> shots;
  for (const char* surface : {"mirror", "refraction", "fresnel", "schlick"})
    shots.push_back({surface, {{"cube_map", "smooth"}, {"surface", surface}}});
  draw("lab08_reflection", shots, folder);
  const auto linear = [&](const char* name, int x, int y, int c) {
    return image::linear_from_srgb(image::load8(folder / fmt::format("{}.png", name)).at(x, y, c) / 255.0);
  };
  for (const char* surface : {"fresnel", "schlick"}) {
    // The share of the mirror's light that, with the rest of the refracted light, fits best around the
    // middle.
    double product = 0, square = 0;
    for (int y = 60; y < 68; y += 2)
      for (int x = 60; x < 68; x += 2)
        for (int c = 0; c < 3; ++c) {
          const double reflected = linear("mirror", x, y, c), refracted = linear("refraction", x, y, c);
          product += (linear(surface, x, y, c) - refracted) * (reflected - refracted);
          square += (reflected - refracted) * (reflected - refracted);
        }
    // ((1.5 - 1) / (1.5 + 1))^2 = 0.04; 8 bits leave it uncertain by 0.01.
    EXPECT_WITHIN(product / square, 0.04, 0.02) << surface;
  }
}

/// The normal of the first sphere on a ray; zero where there is none and near a rim, which triangles cut off.
dvec3 first_normal(const dvec3& eye, const dvec3& ray) {
  double nearest = 1e9;
  dvec3 normal(0);
  for (const glm::dvec4 sphere : environment::kSpheres) {  // centre and radius
    const dvec3 from = eye - dvec3(sphere);
    const double b = glm::dot(from, ray), root = b * b - glm::dot(from, from) + sphere.w * sphere.w;
    const double share = root / (sphere.w * sphere.w);  // 1 in the middle, 0 at the rim
    if (share < -0.1) continue;
    if (share < 0.1) return dvec3(0);
    if (const double distance = -b - std::sqrt(root); distance < nearest) {
      nearest = distance;
      normal = (from + distance * ray) / sphere.w;
    }
  }
  return normal;
}

TEST(SpheresOfLab7, show_the_normal_of_the_nearest_one_by_every_depth_method) {
  const TemporaryFolder folder("spheres");
  // From the left the second sphere stands behind the first, from the front all can be seen. Nothing is as
  // far as depth 0.999, which is 67 units away.
  const double yaws[] = {-40, 0};
  const std::string methods[] = {"far-plane", "test-off", "plane-0999"};
  std::vector<Shot> shots;
  for (const double yaw : yaws)
    for (const std::string& method : methods)
      shots.push_back({fmt::format("{} {}.pfm", method, yaw),
                       {{"yaw", fmt::format("{}", yaw)},
                        {"pitch", "0"},
                        {"distance", "4"},
                        {"field_of_view", "60"},
                        {"near", "0.1"},
                        {"far", "100"},
                        {"depth_method", method}},
                       "direction"});
  draw("lab07_environment", shots, folder);
  for (const double yaw : yaws)
    for (const std::string& method : methods) {
      const image::ImageF direction = image::load_pfm(folder / fmt::format("{} {}.pfm", method, yaw));
      const truth::Camera camera{.yaw = yaw,
                                 .distance = 4,
                                 .field_of_view = 60,
                                 .width = direction.width,
                                 .height = direction.height};
      int seen = 0;
      for (int y = 0; y < direction.height; ++y)
        for (int x = 0; x < direction.width; ++x) {
          const truth::Ray ray = truth::pixel_ray(camera, {x + 0.5, y + 0.5}).ray;
          const dvec3 normal = first_normal(ray.origin, ray.direction);
          if (normal == dvec3(0)) continue;
          ++seen;
          // Between the vertices of 64 x 32 quads, which cut corners: measured 0.005.
          for (int k = 0; k < 3; ++k)
            ASSERT_WITHIN(direction.at(x, y, k), normal[k], 0.01)
                << method << " yaw " << yaw << ": " << x << " " << y;
        }
      EXPECT_GT(seen, direction.width * direction.height / 20);
    }
}

}  // namespace
}  // namespace texel::test
