// SPDX-License-Identifier: MIT
#include "truth/environment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "truth/basis.hpp"

namespace texel::truth {
namespace {

using glm::dvec2;
using glm::dvec3;

TEST(TruthEnvironment, background_is_seen_along_the_view_axis_in_the_middle_and_wider_at_the_sides) {
  const Camera camera{.yaw = 40, .pitch = 10, .field_of_view = 90, .width = 200, .height = 100};
  EXPECT_LT(angle(background_direction(camera, {100, 50}), -camera.eye()), 1e-15);
  EXPECT_LT(angle(background_direction_at_ndc(camera, {0, 0}), -camera.eye()), 1e-15);
  // Half of 90 degrees upwards; to the side twice the tangent, since the picture is twice as wide as high.
  EXPECT_NEAR(angle_in_degrees(background_direction_at_ndc(camera, {0, 1}), -camera.eye()), 45, 1e-13);
  EXPECT_NEAR(std::tan(angle(background_direction_at_ndc(camera, {1, 0}), -camera.eye())), 2, 1e-14);
  EXPECT_EQ(background_direction_at_ndc(camera, {-1, 1}), background_direction(camera, {0, 100}));
}

TEST(TruthEnvironment, turning_the_camera_turns_the_background_and_its_distance_does_not) {
  const dvec2 ndc(0.3, -0.7);
  const dvec3 a = background_direction_at_ndc({.yaw = 0, .distance = 1}, ndc);
  const dvec3 b = background_direction_at_ndc({.yaw = 90, .distance = 50}, ndc);
  EXPECT_LT(glm::distance(b, dvec3(a.z, a.y, -a.x)), 1e-15);
}

TEST(TruthEnvironment, depth_runs_from_near_to_far_and_back_to_the_distance) {
  for (const auto& [near, far] : {std::pair{0.1, 10.0}, {1e-4, 100.0}, {1e-5, 100.0}}) {
    EXPECT_EQ(window_depth(near, near, far), 0.0);
    EXPECT_NEAR(window_depth(far, near, far), 1, 4e-16);
    EXPECT_NEAR(ndc_depth(near, near, far), -1, 4e-16);
    EXPECT_NEAR(ndc_depth(far, near, far), 1, 4e-16);
    for (const double share : {0.01, 0.3, 0.9}) {
      const double distance = near + share * (far - near);
      // The depth's four roundings are worth distance / near times as much in the distance.
      const double back = distance_at_depth(window_depth(distance, near, far), near, far);
      EXPECT_NEAR(back / distance, 1, 4e-16 * (4 + distance / near));
    }
  }
}

TEST(TruthEnvironment, depth_is_the_third_row_of_the_projection_matrix) {
  // (f + n) / (f - n) - 2 f n / ((f - n) d), as OpenGL's perspective matrix has it after division by w = d.
  const double n = 0.05, f = 200;
  for (const double d : {0.05, 0.3, 4.0, 150.0})
    EXPECT_NEAR(ndc_depth(d, n, f), (f + n) / (f - n) - 2 * f * n / ((f - n) * d), 1e-15);
}

TEST(TruthEnvironment, worksheets_plane_at_0_999_lies_at_a_fifth_of_a_unit) {
  // near 1e-4 and far 100: what is drawn at z_ndc = 0.999 hides all that is farther than 0.2.
  EXPECT_NEAR(distance_at_depth(0.5 * (0.999 + 1), 1e-4, 100), 0.1996, 1e-5);
  EXPECT_NEAR(distance_at_depth(0.5 * (0.999 + 1), 0.1, 100), 66.7, 0.1);
}

TEST(TruthEnvironment, depth_step_is_the_distance_between_two_values_of_the_buffer) {
  const double near = 0.05, far = 200, steps = std::ldexp(1.0, 24) - 1;
  for (const double d : {0.05, 1.0, 10.0, 100.0}) {
    const double step = depth_step(d, near, far);
    // Taking the difference of depths near 1 leaves 1e-16 of 6e-8: a part in 1e9.
    EXPECT_NEAR((window_depth(d + step, near, far) - window_depth(d, near, far)) * steps, 1, 2e-8);
    EXPECT_NEAR(step / (d * d * (far - near) / (near * far) / steps), 1, 1e-3) << "its derivative";
  }
  EXPECT_GT(depth_step(1, near, far, 16), 250 * depth_step(1, near, far, 24));
  // Beyond the last value but one, nothing is farther; at this ratio that is long before far.
  EXPECT_GT(depth_step(50, 1e-5, 100), 15.0);
  EXPECT_EQ(depth_step(100, 1e-6, 1e9), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace texel::truth
