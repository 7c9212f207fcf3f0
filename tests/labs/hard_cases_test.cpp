// SPDX-License-Identifier: MIT
// The labs at the inputs at which their techniques fail: what the default method survives, and where the
// others are known to fail, and by how much. Whole pictures, compared with teach/truth pixel by pixel.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

#include "../support/oracles.hpp"
#include "../support/tolerance.hpp"
#include "image/load.hpp"
#include "labs.hpp"
#include "truth/cube_map.hpp"
#include "truth/optics.hpp"
#include "truth/texture.hpp"

namespace texel::test {
namespace {

using glm::dvec2;
using glm::dvec3;
using image::ImageF;

// ---- Float pictures.

dvec3 value_at(const ImageF& picture, int x, int y) {
  return {picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)};
}

/// Calls action(x, y, window) for each pixel; `window` is its middle.
template <class Action>
void for_each_pixel(const ImageF& picture, Action&& action) {
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) action(x, y, dvec2(x + 0.5, y + 0.5));
}

std::string text(double number) {
  return fmt::format("{}", number);
}

Settings settings_of(const truth::Camera& camera) {
  return {{"yaw", text(camera.yaw)},
          {"pitch", text(camera.pitch)},
          {"distance", text(camera.distance)},
          {"field_of_view", text(camera.field_of_view)}};
}

/// World space from object space, as the labs turn their spheres: about the poles first, then forward.
truth::Placement turned(double tilt, double turn) {
  const glm::dmat4 about_x = glm::rotate(glm::dmat4(1), glm::radians(tilt), dvec3(1, 0, 0));
  return {.linear = glm::dmat3(glm::rotate(about_x, glm::radians(turn), dvec3(0, 1, 0)))};
}

// ---- Lab 1.

const char* const kLab1 = "lab01_texture_quad";

/// Looks straight at the square, which has 0.7 of the picture's height.
const truth::Camera kStraight{.distance = 2.4142135};

/// The largest difference between the coordinates of view "texcoord" and the exact ones of the tilted square.
double texcoord_error(const ImageF& picture, double tilt, double offset) {
  truth::Camera camera = kStraight;
  camera.width = picture.width;
  camera.height = picture.height;
  double most = 0;
  for_each_pixel(picture, [&](int x, int y, dvec2 window) {
    if (value_at(picture, x, y) == dvec3(0)) return;  // beside the square
    const auto hit =
        truth::hit_quad(truth::object_ray(truth::pixel_ray(camera, window).ray, truth::tilted(tilt)));
    if (!hit) return;  // a pixel on the edge
    const dvec2 apart = glm::abs(dvec2(value_at(picture, x, y)) - (hit->texcoord + offset));
    most = std::max({most, apart.s, apart.t});
  });
  return most;
}

TEST(HardCaseOfLab1, a_coordinate_with_an_offset_keeps_the_digits_that_a_float_has_left) {
  std::vector<Shot> shots;
  const std::vector<double> offsets = {0, 1e3, 1e4, 1e5, 1e6, 1e7};
  for (const double offset : offsets)
    shots.push_back({text(offset), settings_of(kStraight) + Settings{{"texture_offset", text(offset)}},
                     "texcoord", "128x128"});
  const Pictures pictures = float_pictures(kLab1, shots);
  EXPECT_BELOW(texcoord_error(pictures.at("0"), 0, 0), 1e-6);
  for (const double offset : offsets) {
    if (offset == 0) continue;
    // The spacing of floats there: 2^-14 at 1e3, which is a thirtieth of a texel of 512, up to 1 at 1e7,
    // where the whole picture has two coordinates left. Rounded to the nearest at the corners and again at
    // each pixel: measured 2.0 on softpipe, less on llvmpipe.
    const double spacing = std::ldexp(1.0, std::ilogb(offset) - 23);
    const double most = texcoord_error(pictures.at(text(offset)), 0, offset);
    EXPECT_ABOVE(most, 0.4 * spacing) << offset;
    EXPECT_BELOW(most, 6 * spacing) << offset;
  }
}

TEST(HardCaseOfLab1, coordinates_and_level_of_detail_are_exact_at_grazing_tilts) {
  std::vector<Shot> shots;
  const std::vector<double> tilts = {0, 45, 75, 85, 89, -89};
  for (const double tilt : tilts)
    for (const char* view : {"texcoord", "lod"})
      shots.push_back({fmt::format("{}_{}", view, tilt),
                       settings_of(kStraight) + Settings{{"tilt", text(tilt)}}, view, "256x256"});
  const Pictures pictures = float_pictures(kLab1, shots);
  truth::Camera camera = kStraight;
  camera.width = camera.height = 256;
  for (const double tilt : tilts) {
    // A pixel's step divided by the foreshortening, 1 / cos(tilt): 57 at 89 degrees. Measured 2.4e-6 there.
    EXPECT_BELOW(texcoord_error(pictures.at(fmt::format("texcoord_{}", tilt)), tilt, 0), 1e-5) << tilt;
    const ImageF& levels = pictures.at(fmt::format("lod_{}", tilt));
    double most = 0;
    int pixels = 0;
    for_each_pixel(levels, [&](int x, int y, dvec2 window) {
      const truth::PixelRay pixel = truth::pixel_ray(camera, window);
      const auto hit = truth::hit_quad(truth::object_ray(pixel.ray, truth::tilted(tilt)));
      if (!hit || value_at(levels, x, y) == dvec3(0)) return;
      const truth::SurfacePoint point = truth::placed(truth::quad(), truth::tilted(tilt))(hit->texcoord);
      const double exact = truth::level_of_detail(truth::texcoord_gradient(pixel, point), dvec2(512));
      most = std::max(most, std::abs(levels.at(x, y, 0) - exact));
      ++pixels;
    });
    EXPECT_GT(pixels, 256) << tilt;
    // Differences within a quad of pixels against the derivative in the middle of each: the perspective's
    // change from pixel to pixel grows with 1 / cos(tilt). Measured 0.006 at 45, 0.022 at 75, 0.065 at 85,
    // 0.33 at 89.
    EXPECT_BELOW(most, 0.01 / std::cos(glm::radians(tilt))) << tilt;
  }
}

TEST(HardCaseOfLab1, every_texel_of_an_odd_picture_of_any_format_is_at_its_place) {
  const TemporaryFolder folder;
  const std::vector<std::string> names = {"hard_1x1",       "hard_grey_33x17",       "hard_grey16_67x13",
                                          "hard_rgb_35x21", "hard_grey_alpha_31x19", "hard_rgba_37x23"};
  std::vector<Shot> shots;
  for (const std::string& name : names)
    for (const char* light : {"on", "off"})
      shots.push_back({name + "_" + light,
                       settings_of(kStraight) +
                           Settings{{"texture", name}, {"method", "nearest"}, {"linear_light", light}},
                       "color", "512x512"});
  draw(kLab1, shots, folder);
  for (const std::string& name : names) {
    // A 16-bit file is rounded to 8 bits; grey is the same in red, green and blue.
    const image::Image8 texels = image::load8("assets/textures/" + name + ".png", 3);
    for (const char* light : {"on", "off"}) {
      const image::Image8 picture = image::load8(folder / (name + "_" + light + ".png"));
      for (int t = 0; t < texels.height; ++t)
        for (int s = 0; s < texels.width; ++s) {
          // The square goes from 0.15 to 0.85 of the picture: at least 5 pixels for each texel.
          const auto at = [](int i, int n) { return static_cast<int>(512 * (0.15 + 0.7 * (i + 0.5) / n)); };
          for (int c = 0; c < 3; ++c)
            // Decoded to linear light and encoded again: a rounding.
            ASSERT_WITHIN(picture.at(at(s, texels.width), at(t, texels.height), c), texels.at(s, t, c), 1)
                << name << " linear_light " << light << " texel " << s << " " << t;
        }
    }
  }
}

// ---- Lab 6.

const char* const kLab6 = "lab06_cube_map";

/// What lab 6's sphere, looked up by its own directions, shows of a pixel, exactly.
struct Lookup {
  dvec3 direction;                  ///< in object space
  truth::DirectionGradient change;  ///< per pixel
};

/// Nothing beside the sphere, nor at its rim, where the ray grazes: there the change is infinite, and the
/// triangles decide.
std::optional<Lookup> exact_lookup(const truth::Camera& camera, const truth::Placement& place, dvec2 window) {
  constexpr double rim = 0.1;  // cosine; the outermost 0.9 % of the pixels
  const truth::PixelRay pixel = truth::pixel_ray(camera, window);
  const auto hit = truth::hit_sphere(truth::object_ray(pixel.ray, place));
  if (!hit) return std::nullopt;
  const truth::SurfacePoint point = truth::placed(truth::sphere(), place)(hit->texcoord);
  if (-glm::dot(pixel.ray.direction, point.normal) < rim) return std::nullopt;
  const truth::PositionGradient step = truth::position_gradient(pixel, point);
  const glm::dmat3 object_from_world = glm::transpose(place.linear);
  return Lookup{object_from_world * point.position,
                {object_from_world * step.dx, object_from_world * step.dy}};
}

/// Of how many pixels the level of detail is wrong by more than 3, and by how much at most and on average.
struct Levels {
  int wrong = 0, pixels = 0;
  double most = 0, sum = 0;
  [[nodiscard]] double mean() const { return sum / pixels; }
};

TEST(HardCaseOfLab6, level_of_detail_is_right_at_seam_poles_and_edges_but_for_naive_and_select) {
  // The seam down the middle of the ball, upright and aslant, through neighbours of one quad of pixels (yaw
  // 10) and between two; and the pole leaning to the eye, at the eye, and past it.
  struct Look {
    double tilt, turn, yaw;
  };
  const std::vector<Look> looks = {{0, 180, 0},   {0, 180, 10},  {50, 180, 10}, {60, 170, 3},
                                   {80, 180, 0},  {80, 180, 10}, {90, 180, 0},  {90, 180, 0.2},
                                   {90, 180, 10}, {100, 180, 0}, {100, 180, 10}};
  const std::vector<std::string> methods = {"naive", "select", "wrapped", "analytic"};
  truth::Camera camera{.distance = 3, .width = 256, .height = 256};
  std::vector<Shot> shots;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    camera.yaw = looks[i].yaw;
    const Settings look =
        settings_of(camera) +
        Settings{{"mapping", "sphere-2d"}, {"tilt", text(looks[i].tilt)}, {"turn", text(looks[i].turn)}};
    for (const std::string& method : methods)
      shots.push_back(
          {fmt::format("{}_{}", method, i), look + Settings{{"seam_method", method}}, "lod", "256x256"});
    shots.push_back({fmt::format("cube_{}", i), look + Settings{{"mapping", "cube"}}, "lod", "256x256"});
    shots.push_back({fmt::format("mask_{}", i), look, "mask", "256x256"});
  }
  const Pictures pictures = float_pictures(kLab6, shots);
  std::map<std::string, Levels> all;
  for (std::size_t i = 0; i < looks.size(); ++i) {
    camera.yaw = looks[i].yaw;
    const ImageF& mask = pictures.at(fmt::format("mask_{}", i));
    const truth::Placement place = turned(looks[i].tilt, looks[i].turn);
    for_each_pixel(mask, [&](int x, int y, dvec2 window) {
      const auto seen = exact_lookup(camera, place, window);
      if (!seen || mask.at(x, y, 0) == 0) return;
      // Both the picture and the faces are 512 texels wide.
      const double exact =
          truth::level_of_detail(truth::worksheet_gradient(seen->direction, seen->change), dvec2(512));
      const double exact_of_cube = truth::cube_level_of_detail(seen->direction, seen->change, 512);
      for (const std::string method : {"naive", "select", "wrapped", "analytic", "cube"}) {
        const double error = std::abs(pictures.at(fmt::format("{}_{}", method, i)).at(x, y, 0) -
                                      (method == "cube" ? exact_of_cube : exact));
        Levels& levels = all[method];
        ++levels.pixels;
        if (!(error <= 3)) ++levels.wrong;
        levels.most = std::max(levels.most, error);
        levels.sum += error;
      }
    });
  }
  EXPECT_GT(all["analytic"].pixels, 400000);
  // The difference to the exact derivative is that of the triangles, and of a step of one pixel at the pole.
  // Measured 1.4 levels at most with the formula's derivative and on the cube, and 2.9 with the short way
  // round.
  EXPECT_EQ(all["cube"].wrong, 0);
  // Measured 0.0483 by llvmpipe and by softpipe; 0.134 where one derivative is not divided by the square, and
  // 0.254 where one has the wrong sign.
  EXPECT_BELOW(all["cube"].mean(), 0.09);
  EXPECT_EQ(all["analytic"].wrong, 0);
  EXPECT_BELOW(all["analytic"].most, 2);
  EXPECT_LE(all["wrapped"].wrong, 3);  // 1 by softpipe, 0 by llvmpipe
  // Known to fail: along the whole seam, by 8.9 levels, where neighbours seem to be a whole picture apart;
  // and in a few pixels still when each pixel of a quad makes its own choice.
  // Measured 1013 of 408012, and 78 with select; softpipe, where a quad has one choice, has 1.
  EXPECT_ABOVE(all["naive"].wrong, 500);
  EXPECT_ABOVE(all["naive"].most, 8);
  EXPECT_GT(all["select"].wrong, 0);
  EXPECT_LT(all["select"].wrong, all["naive"].wrong / 8);
}

// ---- Lab 8.

TEST(HardCaseOfLab8, one_ray_for_all_is_9_7_degrees_off_over_pixels_and_11_8_over_the_visible_surface) {
  // Both rays are mirrored at the same normal, so the error is the angle at the eye, 4 away, between the
  // middle of the ball and the point that is seen: tan = sin t / (4 - cos t) for a point at the angle t from
  // the middle. The visible surface ends at cos t = 1/4.
  const double distance = 4;
  constexpr int kSteps = 100000;
  double over_surface = 0, over_pixels = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double share = (i + 0.5) / kSteps;
    // The area of a sphere is even in cos t.
    const double cosine = 1 / distance + (1 - 1 / distance) * share;
    over_surface += std::atan2(std::sqrt(1 - cosine * cosine), distance - cosine) / kSteps;
    // The picture's plane is even in the square of the angle's tangent, up to that of asin(1/4) at the rim.
    over_pixels += std::atan(std::sqrt(share / (distance * distance - 1))) / kSteps;
  }
  EXPECT_WITHIN(glm::degrees(over_surface), 11.797, 1e-3);
  EXPECT_WITHIN(glm::degrees(over_pixels), 9.735, 1e-3);

  // The lab's picture, each pixel counted once, and as much as the surface that it shows.
  const truth::Camera camera{.distance = distance, .field_of_view = 30, .width = 512, .height = 512};
  const Settings look =
      settings_of(camera) + Settings{{"method", "constant-eye"}, {"rings", "256"}, {"segments", "512"}};
  const Pictures pictures = float_pictures(
      "lab08_reflection", {{"direction", look, "direction", "512x512"}, {"mask", look, "mask", "512x512"}});
  double pixels = 0, pixel_sum = 0, area = 0, area_sum = 0;
  for_each_pixel(pictures.at("mask"), [&](int x, int y, dvec2 window) {
    const truth::PixelRay pixel = truth::pixel_ray(camera, window);
    const auto hit = truth::hit_sphere(pixel.ray);
    if (!hit || pictures.at("mask").at(x, y, 0) == 0) return;
    const truth::SurfacePoint point = truth::sphere()(hit->texcoord);
    const dvec3 reflected = truth::reflected(pixel.ray.direction, point.normal);
    const double error = test::angle_in_degrees(value_at(pictures.at("direction"), x, y), reflected);
    const truth::PositionGradient step = truth::position_gradient(pixel, point);
    const double shown = glm::length(glm::cross(step.dx, step.dy));
    ++pixels;
    pixel_sum += error;
    area += shown;
    area_sum += shown * error;
  });
  // Measured 9.734 and 11.794: the pixels' middles are a sum instead of the integral, coarse at the rim.
  EXPECT_WITHIN(pixel_sum / pixels, glm::degrees(over_pixels), 0.02);
  EXPECT_WITHIN(area_sum / area, glm::degrees(over_surface), 0.05);
}

}  // namespace
}  // namespace texel::test
