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

std::size_t distinct_colours(const Image8& picture) {
  std::set<std::array<std::uint8_t, 3>> colours;
  for (std::size_t i = 0; i < picture.samples.size(); i += 3)
    colours.insert({picture.samples[i], picture.samples[i + 1], picture.samples[i + 2]});
  return colours.size();
}

/// Share of the pixels that are not the colour of the empty picture (app/canvas.cpp, 0.035 0.042 0.055 in linear
/// light).
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
    EXPECT_GT(covered(picture), 0.1);
    // A 1x1 texture on a square leaves three: the square, the ground and the mean of both at an edge.
    EXPECT_GE(distinct_colours(picture), 3U);
  }
  // 128x128 pixels of texture or light: measured 1200 and more in the nine labs.
  EXPECT_GT(distinct_colours(image::load8(folder_ / "default.png")), 500U);
}

}  // namespace
}  // namespace texel::test
