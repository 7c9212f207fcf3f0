// SPDX-License-Identifier: MIT
// What the data views show is the quantity that they name, in its unit.

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "../support/tolerance.hpp"
#include "image/load.hpp"
#include "labs.hpp"

namespace texel::test {
namespace {

using image::ImageF;

class Views : public EveryLab {};
INSTANTIATE_TEST_SUITE_P(Labs, Views, each_lab, lab_name);

/// The labs whose one object is a square; the others show a sphere, by default or as their model.
const std::string kSquares[] = {"lab01_texture_quad", "lab02_multi_texture"};

/// Where the ray of a pixel meets the unit sphere, as the distance along the view axis from an eye that is
/// `distance` away; 0 where it passes by or comes near the rim, where the triangles end.
double sphere_depth(const ImageF& picture, int x, int y, double distance, double field_of_view) {
  const double t = std::tan(glm::radians(field_of_view) / 2) * 2 / picture.height;
  const double u = t * (x + 0.5 - picture.width / 2.0), v = t * (y + 0.5 - picture.height / 2.0);
  // |d (u, v, 1) - (0, 0, distance)| = 1, the nearer of two.
  const double a = u * u + v * v + 1, root = distance * distance - a * (distance * distance - 1);
  return root < 0.3 ? 0 : (distance - std::sqrt(root)) / a;
}

TEST_P(Views, depth_is_the_distance_along_the_view_axis_in_wide_pictures_too) {
  // A square or a sphere in front of the camera, whatever the lab can show.
  const bool is_square = std::count(std::begin(kSquares), std::end(kSquares), lab()) > 0;
  Settings look = {{"yaw", "0"}, {"pitch", "0"}, {"distance", "3"}, {"field_of_view", "45"}};
  if (has_parameter(lab(), "model")) look.emplace_back("model", "sphere");
  draw(lab(), {{"depth.pfm", look, "depth", "96x64"}}, folder_);
  const ImageF depth = image::load_pfm(folder_ / "depth.pfm");
  int seen = 0;
  for (int y = 0; y < depth.height; ++y)
    for (int x = 0; x < depth.width; ++x) {
      const double expected = is_square && depth.at(x, y) > 0 ? 3 : sphere_depth(depth, x, y, 3, 45);
      if (expected == 0 || (is_square && depth.at(x, y) == 0)) continue;
      ++seen;
      // Triangles of 64 x 32 quads lie up to 1 - cos(pi / 32) / 2 = 0.0024 below the sphere, and a ray that
      // meets them aslant goes twice as far to them. Measured 0.0040.
      const double tolerance = is_square ? 1e-6 : 0.005;
      ASSERT_WITHIN(depth.at(x, y), expected, tolerance) << x << " " << y;
    }
  EXPECT_GT(seen, depth.height * depth.height / 8);
}

class LevelView : public EveryLab {};
INSTANTIATE_TEST_SUITE_P(Labs, LevelView,
                         testing::Values("lab01_texture_quad", "lab02_multi_texture", "lab03_obj_texcoords",
                                         "lab04_cube_wrap"),
                         lab_name);

/// The level of detail at the left of two neighbours, from the coordinates as the view shows them: log2 of
/// the longer side of the pixel's footprint in texels.
double level_between(const ImageF& texcoord, int x, int y, double size) {
  const auto side = [&](int to_x, int to_y) {
    return size * std::hypot(double{texcoord.at(to_x, to_y, 0)} - texcoord.at(x, y, 0),
                             double{texcoord.at(to_x, to_y, 1)} - texcoord.at(x, y, 1));
  };
  return std::log2(std::max(side(x + 1, y), side(x, y + 1)));
}

TEST_P(LevelView, is_the_logarithm_of_how_many_texels_a_pixel_covers) {
  const Settings camera = {{"yaw", "0"}, {"pitch", "0"}, {"distance", "3"}, {"field_of_view", "45"}};
  Settings look = camera + Settings{{"texture_scale", "3"}};
  // Leaning back, and seen from below: one side of the footprint is longer than the other.
  if (has_parameter(lab(), "tilt"))
    look = look + Settings{{"tilt", "60"}};
  else
    look = look + Settings{{"model", "quad"}, {"pitch", "0"}, {"yaw", "60"}};
  look.emplace_back(has_parameter(lab(), "texture") ? "texture" : "texture0", "brick");
  draw(lab(),
       {{"lod.pfm", look, "lod", "128x128"},
        {"texcoord.pfm", look, "texcoord", "128x128"},
        {"mask.pfm", look, "mask", "128x128"}},
       folder_);
  const ImageF level = image::load_pfm(folder_ / "lod.pfm"),
               texcoord = image::load_pfm(folder_ / "texcoord.pfm"),
               mask = image::load_pfm(folder_ / "mask.pfm");
  int seen = 0;
  // The graphics card takes differences in squares of 2x2 pixels; their left lower pixel has both of them.
  for (int y = 0; y < level.height; y += 2)
    for (int x = 0; x < level.width; x += 2) {
      const auto inside = [&](int i, int j) { return mask.at(i, j) == 1; };
      if (!inside(x, y) || !inside(x + 1, y) || !inside(x, y + 1) || !inside(x + 1, y + 1)) continue;
      ++seen;
      // float32 differences of coordinates up to 3 that are 0.02 apart: 2e-5 of them, 3e-5 of a level.
      // softpipe is off by 0.0018.
      ASSERT_WITHIN(level.at(x, y), level_between(texcoord, x, y, 512), 6e-3) << x << " " << y;
    }
  EXPECT_GT(seen, 64 * 64 / 8);
}

}  // namespace
}  // namespace texel::test
