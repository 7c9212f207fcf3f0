// SPDX-License-Identifier: MIT
#include "image/data_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace texel::image {
namespace {

TEST(DataViews, are_shown_in_the_labs_colors) {
  struct Row {
    const char* view;
    std::vector<float> value;
    std::vector<std::uint8_t> color;
  };
  const Row rows[] = {{"normal", {0, 0, 1}, {128, 128, 255}},        {"direction", {-1, 1, 0}, {0, 255, 128}},
                      {"texcoord", {1.25F, -0.75F, 0}, {64, 64, 0}}, {"depth", {4, 4, 4}, {128, 128, 128}},
                      {"mask", {1, 1, 1}, {255, 255, 255}},          {"lod", {9, 0, 0}, {250, 230, 28}},
                      {"normal", {0, 0, 0}, {51, 56, 64}},           {"lod", {NAN, 0, 0}, {255, 0, 255}},
                      {"depth", {-INFINITY, 0, 0}, {255, 0, 255}}};
  for (const Row& row : rows) {
    ImageF one(1, 1, 3);
    one.samples = row.value;
    EXPECT_EQ(shown(one, row.view).samples, row.color) << row.view;
  }
}

}  // namespace
}  // namespace texel::image
