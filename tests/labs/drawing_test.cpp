// SPDX-License-Identifier: MIT
// Every value of every choice, and every view, of every lab draws something.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "image/load.hpp"
#include "labs.hpp"

namespace texel::test {
namespace {

using image::Image8;
using image::ImageF;

class Drawing : public EveryLab {};
INSTANTIATE_TEST_SUITE_P(Labs, Drawing, each_lab, lab_name);

std::size_t distinct_colors(const Image8& picture) {
  std::set<std::array<std::uint8_t, 3>> colors;
  for (std::size_t i = 0; i < picture.samples.size(); i += 3)
    colors.insert({picture.samples[i], picture.samples[i + 1], picture.samples[i + 2]});
  return colors.size();
}

/// Share of the pixels that are not the colour of the empty picture (app/canvas.cpp, 0.035 0.042 0.055 in
/// linear light).
double covered(const Image8& picture) {
  int count = 0;
  for (std::size_t i = 0; i < picture.samples.size(); i += 3)
    count += picture.samples[i] != 53 || picture.samples[i + 1] != 58 || picture.samples[i + 2] != 66;
  return static_cast<double>(count) / (static_cast<double>(picture.samples.size()) / 3);
}

/// Every value of every choice, toggle and bundled file once, and every number at both ends of its range.
std::vector<Shot> every_value(const std::string& lab) {
  std::vector<Shot> shots = {{"default"}};
  for (const Parameter& p : parameters_of(lab)) {
    std::vector<std::string> values = p.choices;
    if (p.type == "toggle") values = {"on", "off"};
    for (const std::string& value : values)
      if (value != p.initial) shots.push_back({fmt::format("{}={}", p.name, value), {{p.name, value}}});
  }
  return shots;
}

TEST_P(Drawing, shows_something_for_every_value_of_every_choice) {
  const std::vector<Shot> shots = every_value(lab());
  draw(lab(), shots, folder_);
  for (const Shot& shot : shots) {
    SCOPED_TRACE(shot.name);
    const Image8 picture = image::load8(folder_ / (shot.name + ".png"));
    // The least is the alligator of lab 5, long and flat: 6 %.
    EXPECT_GT(covered(picture), 0.05);
    // A 1x1 texture on a square leaves two, the square and the ground, where the driver has one sample a
    // pixel.
    EXPECT_GE(distinct_colors(picture), shot.name.find("1x1") == std::string::npos ? 3U : 2U);
  }
  // 128x128 pixels of texture or light: measured 1200 and more in the first nine labs.
  EXPECT_GT(distinct_colors(image::load8(folder_ / "default.png")), 500U);
}

bool holds_unit_vectors(const std::string& view) {
  return view == "normal" || view == "tangent" || view == "direction";
}

/// The default look in all data views, and every other method in them.
std::vector<Shot> every_view(const std::string& lab) {
  std::vector<Shot> shots;
  const std::vector<Parameter> parameters = parameters_of(lab);
  const auto method = std::find_if(parameters.begin(), parameters.end(),
                                   [](const Parameter& p) { return p.name == "method"; });
  for (const std::string& view : views_of(lab)) {
    if (view == "color" || view == "error") continue;  // errors: error_test.cpp
    shots.push_back({view + ".pfm", {}, view});
    for (const std::string& value : method->choices)
      if (value != method->initial)
        shots.push_back({fmt::format("{} by {}.pfm", view, value), {{"method", value}}, view, "64x64"});
  }
  return shots;
}

TEST_P(Drawing, shows_finite_values_in_every_view) {
  const std::vector<Shot> shots = every_view(lab());
  draw(lab(), shots, folder_);
  const ImageF mask = image::load_pfm(folder_ / "mask.pfm");
  int objects = 0;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      EXPECT_TRUE(mask.at(x, y) == 0 || mask.at(x, y) == 1) << mask.at(x, y);
      objects += mask.at(x, y) == 1;
    }
  EXPECT_GT(objects, mask.width * mask.height / 10);

  for (const Shot& shot : shots) {
    SCOPED_TRACE(shot.name);
    const ImageF values = image::load_pfm(folder_ / shot.name);
    if (!shot.values.empty()) continue;  // the methods that fail somewhere are there to show it
    int not_finite = 0, not_unit = 0, not_background = 0;
    for (int y = 0; y < values.height; ++y)
      for (int x = 0; x < values.width; ++x) {
        const double a = values.at(x, y, 0), b = values.at(x, y, 1), c = values.at(x, y, 2);
        not_finite += !std::isfinite(a + b + c);
        // Lab 7 is about what surrounds the objects: its views show that too.
        if (mask.at(x, y) == 0 && lab() != "lab07_environment") not_background += a != 0 || b != 0 || c != 0;
        // normalize() in float32: measured 2e-7 off.
        else if (holds_unit_vectors(shot.view))
          not_unit += !(std::abs(std::hypot(a, b, c) - 1) < 1e-6);
      }
    EXPECT_EQ(not_finite, 0);
    EXPECT_EQ(not_unit, 0);
    EXPECT_EQ(not_background, 0);
  }
}

}  // namespace
}  // namespace texel::test
