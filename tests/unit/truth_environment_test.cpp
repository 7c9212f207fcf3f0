// SPDX-License-Identifier: MIT
#include "truth/environment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "../support/oracles.hpp"

namespace texel::truth {
namespace {

using glm::dvec2;
using glm::dvec3;
using test::angle;
using test::angle_in_degrees;

TEST(TruthEnvironment, background_is_seen_along_the_view_axis_in_the_middle_and_wider_at_the_sides) {
  const Camera camera{.yaw = 40, .pitch = 10, .field_of_view = 90, .width = 200, .height = 100};
  EXPECT_LT(angle(background_direction(camera, {100, 50}), -camera.eye()), 1e-15);
  // Half of 90 degrees upwards; to the side twice the tangent, since the picture is twice as wide as high.
  EXPECT_NEAR(angle_in_degrees(background_direction(camera, {100, 100}), -camera.eye()), 45, 1e-13);
  EXPECT_NEAR(std::tan(angle(background_direction(camera, {200, 50}), -camera.eye())), 2, 1e-14);
}

TEST(TruthEnvironment, turning_the_camera_turns_the_background_and_its_distance_does_not) {
  const dvec2 window(170, 30);
  const dvec3 a = background_direction({.yaw = 0, .distance = 1}, window);
  const dvec3 b = background_direction({.yaw = 90, .distance = 50}, window);
  EXPECT_LT(glm::distance(b, dvec3(a.z, a.y, -a.x)), 1e-15);
}

}  // namespace
}  // namespace texel::truth
