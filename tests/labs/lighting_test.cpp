// SPDX-License-Identifier: MIT
// shaders/lib/light.glsl, seen through the labs that have a light: every pixel of a white square against
// Blinn's formula in double precision.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "../support/tolerance.hpp"
#include "image/color.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "labs.hpp"
#include "truth/ray.hpp"

namespace texel::test {
namespace {

using glm::dvec3;

constexpr int kPixels = 64;
/// 8 bits are rounded by 0.5. With 1/sqrt off by as much as RSQRTPS may be (./run renderers has it) 0.65 was
/// measured, with an exact one 0.59; softpipe 0.54. Beyond the rounding that is three times as much and more.
constexpr double kMostSteps = 1;
constexpr double kDistance = 2.5, kFieldOfView = 30;  // the square fills the picture from the front

/// Degrees; (0, 0) is +z.
dvec3 direction(double yaw, double pitch) {
  const double a = glm::radians(yaw), b = glm::radians(pitch);
  return {std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
}

struct Case {
  double eye_yaw, light_yaw, light_pitch, ambient, specular;
};

/// What a point of the plane z = 0 sends to the eye (J. Blinn, 1977): ambient light, the rest by the cosine,
/// and a highlight where the normal lies halfway between light and eye, but none on a side without light.
double blinn(const Case& c, double albedo, const dvec3& point, const dvec3& eye) {
  const dvec3 light = direction(c.light_yaw, c.light_pitch);
  const double diffuse = std::max(light.z, 0.0);
  const double half = std::max(glm::normalize(light + glm::normalize(eye - point)).z, 0.0);
  const double highlight = light.z > 0 ? std::pow(half, 48) : 0;
  return albedo * (c.ambient + (1 - c.ambient) * diffuse) + c.specular * highlight;
}

/// Where the ray through a place of the picture meets z = 0.
dvec3 on_square(const truth::Camera& camera, glm::dvec2 window) {
  const truth::Ray ray = truth::pixel_ray(camera, window).ray;
  return ray.origin - ray.origin.z / ray.direction.z * ray.direction;
}

class Lighting : public EveryLab {};
INSTANTIATE_TEST_SUITE_P(Labs, Lighting,
                         testing::Values("lab03_obj_texcoords", "lab04_cube_wrap", "lab05_normal_map"),
                         lab_name);

TEST_P(Lighting, of_a_square_is_blinn_s) {
  // Grey of 128 is 0.2158 in linear light, so that no sum is beyond 1.
  image::Image8 grey(1, 1, 3);
  std::fill(grey.samples.begin(), grey.samples.end(), std::uint8_t{128});
  const std::string texture = (folder_ / "grey.png").string();
  image::save_png(texture, grey);
  const Case cases[] = {{0, 0, 0, 0.25, 0},     // from the front
                        {0, 40, 30, 0.25, 0},   // aslant
                        {20, -30, 10, 0, 0.7},  // a highlight, without ambient light
                        {0, 170, 20, 0.3, 1},   // from behind: ambient light alone
                        {60, -92, 0, 0.2, 1}};  // 2 degrees behind, with the normal halfway to the eye
  std::vector<Shot> shots;
  for (const Case& c : cases) {
    const auto text = [](double number) { return fmt::format("{}", number); };
    Settings values = {{"model", "quad"},
                       {"texture", texture},
                       {"yaw", text(c.eye_yaw)},
                       {"pitch", "0"},
                       {"distance", text(kDistance)},
                       {"field_of_view", text(kFieldOfView)},
                       {"turn", "0"},
                       {"light_yaw", text(c.light_yaw)},
                       {"light_pitch", text(c.light_pitch)},
                       {"ambient", text(c.ambient)},
                       {"specular", text(c.specular)}};
    if (lab() == "lab05_normal_map") values.emplace_back("normal_mapping", "off");
    if (lab() == "lab04_cube_wrap") std::erase_if(values, [](const auto& v) { return v.first == "turn"; });
    shots.push_back({fmt::format("{}", shots.size()), values, "color", fmt::format("{0}x{0}", kPixels)});
  }
  draw(lab(), shots, folder_);
  const double albedo = image::linear_from_srgb(128 / 255.0);
  for (std::size_t i = 0; i < shots.size(); ++i) {
    SCOPED_TRACE(flags(shots[i].values));
    const image::Image8 picture = image::load8(folder_ / (shots[i].name + ".png"));
    const truth::Camera camera{.yaw = cases[i].eye_yaw,
                               .distance = kDistance,
                               .field_of_view = kFieldOfView,
                               .width = kPixels,
                               .height = kPixels};
    int seen = 0;
    double worst = 0;
    for (int y = 0; y < kPixels; ++y)
      for (int x = 0; x < kPixels; ++x) {
        const dvec3 point = on_square(camera, {x + 0.5, y + 0.5});
        if (std::max(std::abs(point.x), std::abs(point.y)) > 0.6) continue;  // half-size 0.7 in all three
        ++seen;
        const double expected = 255 * image::srgb_from_linear(blinn(cases[i], albedo, point, camera.eye()));
        for (int channel = 0; channel < 3; ++channel)
          worst = std::max(worst, std::abs(picture.at(x, y, channel) - expected));
      }
    EXPECT_GT(seen, kPixels * kPixels / 4);
    EXPECT_BELOW(worst, kMostSteps);
  }
}

}  // namespace
}  // namespace texel::test
