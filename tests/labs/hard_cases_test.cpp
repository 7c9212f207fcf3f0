// SPDX-License-Identifier: MIT
// Lab 1 at the inputs at which its techniques fail. Whole pictures, compared with teach/truth pixel by pixel.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "../support/oracles.hpp"
#include "../support/tolerance.hpp"
#include "image/load.hpp"
#include "labs.hpp"
#include "truth/ray.hpp"
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
        truth::hit_quad(truth::object_ray(truth::ray_through(camera, window), truth::tilted(tilt)));
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

}  // namespace
}  // namespace texel::test
