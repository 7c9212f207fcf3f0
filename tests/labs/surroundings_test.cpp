// SPDX-License-Identifier: MIT
// What labs 6 to 9 show where two things meet: the faces of a cube map, spheres one behind the other, the
// edges of one picture for all directions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/glm.hpp>

#include "../support/tolerance.hpp"
#include "image/color.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "labs.hpp"

namespace texel::test {
namespace {

using glm::dvec3;
using image::Image8;

/// The largest step from one pixel of the middle row to the next, over the middle half of the picture.
int largest_step(const Image8& picture) {
  int largest = 0;
  for (int x = picture.width / 4; x < picture.width * 3 / 4; ++x)
    largest = std::max(
        largest, std::abs(picture.at(x + 1, picture.height / 2, 0) - picture.at(x, picture.height / 2, 0)));
  return largest;
}

TEST(EdgeOfLab6, is_filtered_across_by_the_seamless_methods_alone) {
  const TemporaryFolder folder("edge");
  // A white face beside black ones, of 2x2 texels, so that what is between two texels is wide.
  std::filesystem::create_directories(folder / "faces");
  for (const std::string face : {"px", "nx", "py", "ny", "pz", "nz"}) {
    Image8 picture(2, 2, 3);
    std::fill(picture.samples.begin(), picture.samples.end(), std::uint8_t(face == "px" ? 255 : 0));
    image::save_png(folder / fmt::format("faces/{}.png", face), picture);
  }
  // The edge between +X and +Z stands upright in the middle.
  const Settings look = {{"cube_map", (folder / "faces").string()},
                         {"mapping", "cube"},
                         {"turn", "0"},
                         {"tilt", "0"},
                         {"yaw", "45"},
                         {"pitch", "0"}};
  std::vector<Shot> shots;
  for (const char* method : {"nearest", "linear", "linear-seamless", "mipmapped"})
    shots.push_back({method, look + Settings{{"method", method}}});
  draw("lab06_cube_map", shots, folder);
  const auto step = [&](const char* method) {
    return largest_step(image::load8(folder / fmt::format("{}.png", method)));
  };
  EXPECT_EQ(step("nearest"), 255);
  EXPECT_EQ(step("linear"), 255);
  // From black to white over half of each face.
  EXPECT_BELOW(step("linear-seamless"), 60);
  EXPECT_BELOW(step("mipmapped"), 60);
}

TEST(LookupOfLab8, shows_the_same_surroundings_in_one_picture_as_in_six) {
  const TemporaryFolder folder("lookup");
  std::vector<Shot> shots;
  // From behind, a little to the side: the seam of the equirectangular picture stands upright on the ball.
  for (const char* lookup : {"cube", "sphere-map", "equirectangular"})
    shots.push_back(
        {lookup, {{"cube_map", "smooth"}, {"lookup", lookup}, {"yaw", "150"}}, "color", "256x256"});
  draw("lab08_reflection", shots, folder);
  const auto load = [&](const char* name) { return image::load8(folder / fmt::format("{}.png", name)); };
  const auto mean = [&](const char* name) { return image::compare(load("cube"), load(name)).mean; };
  // In 8-bit steps over a picture of 256x256: measured 0.4, with its middle or its axis elsewhere 31 and
  // more.
  EXPECT_BELOW(mean("sphere-map"), 1);
  // 0.11 by llvmpipe and 0.14 by softpipe, with a coarse level along the seam 0.25.
  EXPECT_BELOW(mean("equirectangular"), 0.19);
}

/// How far neighbours in a row are apart, in the mean: the finer the detail, the more.
double detail(const image::Image8& picture) {
  double sum = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 1; x < picture.width; ++x)
      for (int c = 0; c < 3; ++c) sum += std::abs(picture.at(x, y, c) - picture.at(x - 1, y, c));
  return sum / static_cast<double>(picture.samples.size());
}

TEST(RoughMirrorOfLab9, is_rough_where_a_pixel_covers_many_bumps_and_smooth_where_there_are_none) {
  const TemporaryFolder folder("rough");
  // So near that a pixel is less than a texel of the cube map: drivers agree on its level.
  const Settings flat = {{"normal_map", "flat"}, {"field_of_view", "5"}};
  draw("lab09_bump",
       {{"plain", flat, "color", "256x256"},
        {"toksvig", flat + Settings{{"mip_filter", "toksvig"}}, "color", "256x256"},
        {"far",
         {{"repeats", "64"},
          {"bump_strength", "1"},
          {"distance", "5"},
          {"field_of_view", "20"},
          {"mip_filter", "toksvig"}},
         "color",
         "256x256"}},
       folder);
  const auto load = [&](const char* name) { return image::load8(folder / fmt::format("{}.png", name), 3); };
  // In 8-bit steps. Measured 0; where rounding counts as roughness 19.
  EXPECT_BELOW(image::compare(load("plain"), load("toksvig")).mean, 3);
  // Measured 6.2; without the roughness 11.3.
  EXPECT_BELOW(detail(load("far")), 9);
}

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

/// Centre and radius, as labs/07_environment/scene.hpp has them.
struct Sphere {
  dvec3 center;
  double radius;
};
constexpr Sphere kSpheres[] = {{{0, 0, 0}, 1},
                               {{3.1, -0.6, -2.2}, 0.9},
                               {{-4.6, -0.6, -7}, 1.2},
                               {{6.5, 1.8, -8}, 1.2},
                               {{-7, 8, -16}, 2}};

/// The normal of the first sphere on a ray; zero where there is none and near a rim, which triangles cut off.
dvec3 first_normal(const dvec3& eye, const dvec3& ray) {
  double nearest = 1e9;
  dvec3 normal(0);
  for (const Sphere& sphere : kSpheres) {
    const dvec3 from = eye - sphere.center;
    const double b = glm::dot(from, ray), root = b * b - glm::dot(from, from) + sphere.radius * sphere.radius;
    const double share = root / (sphere.radius * sphere.radius);  // 1 in the middle, 0 at the rim
    if (share < -0.1) continue;
    if (share < 0.1) return dvec3(0);
    if (const double distance = -b - std::sqrt(root); distance < nearest) {
      nearest = distance;
      normal = (from + distance * ray) / sphere.radius;
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
  const double half = std::tan(glm::radians(60.0) / 2);
  for (const double yaw : yaws)
    for (const std::string& method : methods) {
      const image::ImageF direction = image::load_pfm(folder / fmt::format("{} {}.pfm", method, yaw));
      const double a = glm::radians(yaw);
      const dvec3 back(std::sin(a), 0, std::cos(a)), right(std::cos(a), 0, -std::sin(a));
      int seen = 0;
      for (int y = 0; y < direction.height; ++y)
        for (int x = 0; x < direction.width; ++x) {
          const double u = half * (2 * (x + 0.5) / direction.width - 1),
                       v = half * (2 * (y + 0.5) / direction.height - 1);
          const dvec3 normal =
              first_normal(4.0 * back, glm::normalize(u * right + v * dvec3(0, 1, 0) - back));
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
