// SPDX-License-Identifier: MIT
#include "image/data_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace texel::image {
namespace {

TEST(DataViews, are_shown_in_the_labs_colors) {
  const auto color = [](const std::string& view, float x, float y, float z) {
    ImageF one(1, 1, 3);
    one.samples = {x, y, z};
    const Image8 picture = shown(one, view);
    return std::vector<int>(picture.samples.begin(), picture.samples.end());
  };
  using Color = std::vector<int>;
  EXPECT_EQ(color("normal", 0, 0, 1), (Color{128, 128, 255}));
  EXPECT_EQ(color("direction", -1, 1, 0), (Color{0, 255, 128}));
  EXPECT_EQ(color("texcoord", 1.25F, -0.75F, 0), (Color{64, 64, 0}));
  EXPECT_EQ(color("depth", 4, 4, 4), (Color{128, 128, 128}));
  EXPECT_EQ(color("mask", 1, 1, 1), (Color{255, 255, 255}));
  EXPECT_EQ(color("normal", 0, 0, 0), (Color{51, 56, 64}));
  EXPECT_EQ(color("lod", NAN, 0, 0), (Color{255, 0, 255}));
  EXPECT_EQ(color("depth", -INFINITY, 0, 0), (Color{255, 0, 255}));
}

}  // namespace
}  // namespace texel::image
