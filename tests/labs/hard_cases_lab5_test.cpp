// SPDX-License-Identifier: MIT
// Lab 5 where tangent frames are hard: leaning, squeezed and mirrored textures, coarse triangles. What the
// default method survives, and by how much the others are known to fail.
#include <algorithm>
#include <cmath>

#include "../support/oracles.hpp"
#include "../support/tolerance.hpp"
#include "labs.hpp"
#include "procedural/height_fields.hpp"
#include "truth/ray.hpp"
#include "truth/relief.hpp"

namespace texel::test {
namespace {

using glm::dvec2;
using glm::dvec3;
using image::ImageF;

const char* const kLab5 = "lab05_normal_map";

// ---- Tangents on surfaces with a formula, pixel by pixel.

const truth::Camera kCamera{.yaw = 32, .pitch = 24, .distance = 3};  // the lab's

std::optional<truth::Hit> hit_model(const std::string& model, const truth::Ray& ray) {
  if (model == "quad") return truth::hit_quad(ray, 0.7);
  if (model == "cube") return truth::hit_cube(ray, 0.577);
  return truth::hit_torus(ray, 0.7, 0.3);
}
truth::Surface surface_of(const std::string& model, image::Face face) {
  if (model == "quad") return truth::quad(0.7);
  if (model == "cube") return truth::cube_face(face, 0.577);
  return truth::torus(0.7, 0.3);
}

/// Degrees between two directions: mean and 99th percentile over the picture.
struct Spread {
  double mean = 0, p99 = 0;
};

/// Of a picture of unit vectors against what `exact(point, texcoord)` says of the point that a pixel sees.
template <class Exact>
Spread degrees_off(const ImageF& picture, const std::string& model, const truth::TexcoordMap& map,
                   Exact exact) {
  truth::Camera camera = kCamera;
  camera.width = picture.width, camera.height = picture.height;
  std::vector<double> degrees;
  double sum = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto hit = hit_model(model, truth::ray_through(camera, dvec2(x + 0.5, y + 0.5)));
      const dvec3 drawn(picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2));
      if (!hit || !(glm::length(drawn) > 0.5)) continue;  // at the outline
      const truth::Surface surface = truth::reparameterized(surface_of(model, hit->face), map);
      const dvec2 texcoord = map.texcoord(hit->texcoord);
      const dvec3 right = exact(surface(texcoord), texcoord);
      degrees.push_back(test::angle_in_degrees(drawn, right));
      sum += degrees.back();
    }
  if (degrees.empty()) return {};
  std::sort(degrees.begin(), degrees.end());
  return {sum / static_cast<double>(degrees.size()), degrees[degrees.size() * 99 / 100]};
}

/// Where s grows and t does not.
dvec3 along_s(const truth::SurfacePoint& point, dvec2 /*texcoord*/ = {}) {
  return test::parametric_frame(point).tangent;
}
/// Where s grows fastest.
dvec3 steepest_s(const truth::SurfacePoint& point, dvec2 /*texcoord*/) {
  return truth::surface_gradient(point, {1, 0});
}

struct Layout {
  const char* name;
  Settings settings;
  truth::TexcoordMap map;
};
const Layout kPlain{"plain", {}, {}};
const Layout kMirrored{"mirrored", {{"mirror", "on"}}, test::mirrored()};
const Layout kSqueezed{"squeezed", {{"texture_stretch", "4"}}, test::stretched(4)};
const Layout kLong{"long", {{"texture_stretch", "0.25"}}, test::stretched(0.25)};
const Layout kLeaning{"leaning", {{"texture_shear", "1"}}, test::sheared(std::atan(1.0))};

/// The view `tangent` of a model under a layout.
ImageF tangents(const std::string& model, const Layout& layout, const std::string& method) {
  const Settings look =
      Settings{{"model", model}, {"method", method}, {"normal_map", "flat"}} + layout.settings;
  return float_pictures(kLab5, {{"tangent", look, "tangent", "128x128"}}).at("tangent");
}

TEST(HardCaseOfLab5, derivative_frame_is_exact_where_the_texture_keeps_right_angles) {
  // Position and texture coordinate are linear on a triangle, so that their differences from pixel to pixel
  // are exact but for float32: a step of 0.01 in a position of 1 is good to 1e-5 radians. Measured 0.0005
  // degrees at the 99th percentile; the cube's edges, where a pixel may lie on the other face, are the rest.
  for (const char* model : {"quad", "cube"})
    for (const Layout& layout : {kPlain, kMirrored, kSqueezed, kLong})
      EXPECT_BELOW(degrees_off(tangents(model, layout, "cotangent"), model, layout.map, along_s).p99, 0.002)
          << model << " " << layout.name;
}

TEST(HardCaseOfLab5, under_shear_the_derivative_frame_has_the_steepest_way_of_s_and_the_others_its_line) {
  // T is where s grows fastest, or where s grows and t does not: 45 degrees apart on a square that leans
  // by 45.
  const ImageF cotangent = tangents("quad", kLeaning, "cotangent"),
               mikktspace = tangents("quad", kLeaning, "mikktspace");
  EXPECT_BELOW(degrees_off(cotangent, "quad", kLeaning.map, steepest_s).p99, 0.002);
  EXPECT_WITHIN(degrees_off(cotangent, "quad", kLeaning.map, along_s).mean, 45, 0.01);
  EXPECT_BELOW(degrees_off(mikktspace, "quad", kLeaning.map, along_s).p99, 0.0001);
  EXPECT_WITHIN(degrees_off(mikktspace, "quad", kLeaning.map, steepest_s).mean, 45, 0.01);
}

TEST(HardCaseOfLab5, screen_axes_are_tens_of_degrees_off_and_turned_round_on_a_mirrored_texture) {
  // Measured 20 on the cube, whose walls happen to stand along the screen, 53 on the torus, and 127 mirrored.
  const auto mean = [](const char* model, const Layout& layout) {
    return degrees_off(tangents(model, layout, "screen-axes"), model, layout.map, along_s).mean;
  };
  EXPECT_ABOVE(mean("cube", kPlain), 15);
  EXPECT_ABOVE(mean("torus", kPlain), 40);
  EXPECT_ABOVE(mean("torus", kMirrored), 90);
}

TEST(HardCaseOfLab5, tangents_in_a_pixel_are_those_of_the_triangles_on_the_torus) {
  // Measured in the mean: 0.73 (flat triangles), 0.11, 0.08, 0.08, 0.07 and 0.06: of the latter, the place of
  // the flat triangle's pixel on the round surface, not the tangents.
  for (const auto& [method, limit] : {std::pair("cotangent", 1.0),
                                      {"averaged", 0.15},
                                      {"gram-schmidt", 0.11},
                                      {"angle-weighted", 0.11},
                                      {"mikktspace", 0.1},
                                      {"analytic", 0.09}})
    for (const Layout& layout : {kPlain, kMirrored})
      EXPECT_BELOW(degrees_off(tangents("torus", layout, method), "torus", layout.map, along_s).mean, limit)
          << method << " " << layout.name;
}

// ---- Shading normals against the two truths.

TEST(HardCaseOfLab5, derivative_frame_has_the_slope_of_a_height_field_but_for_one_factor) {
  // It is scaled to the longer of its two vectors. Under shear the gradient of s is sqrt(2) times as long as
  // that of t; squeezed, 4 times. Measured 0.14 and 0.21 where pixels are small: 8 bits and the filter.
  for (const auto& [layout, too_long] : {std::pair(kLeaning, std::sqrt(2.0)), {kSqueezed, 4.0}}) {
    const ImageF normals =
        float_pictures(kLab5, {{"normal",
                                Settings{{"model", "quad"}, {"method", "cotangent"}, {"normal_map", "bump"}} +
                                    layout.settings,
                                "normal", "512x512"}})
            .at("normal");
    const auto relief = [factor = too_long](const truth::SurfacePoint& point, dvec2 texcoord) {
      const procedural::Dual height =
          procedural::height(procedural::HeightField::bump, texcoord.s, texcoord.t);
      return truth::relief_normal(point, 1.4 / factor * dvec2(height.du, height.dv));  // the quad is 1.4 wide
    };
    EXPECT_BELOW(degrees_off(normals, "quad", layout.map, relief).mean, 0.45) << layout.name;
  }
}

}  // namespace
}  // namespace texel::test
