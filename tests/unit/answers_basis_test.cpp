// SPDX-License-Identifier: MIT
#include "answers/basis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "../support/directions.hpp"
#include "../support/oracles.hpp"
#include "truth/surface.hpp"

namespace texel::answers {
namespace {

using glm::dvec3;
using glm::vec3;

/// |G - I| of a frame in floats, calculated in double.
double error(const glm::mat3& frame) {
  return test::orthonormality(glm::dmat3(frame));
}

bool is_finite(const glm::mat3& m) {
  return std::isfinite(glm::dot(m[0], vec3(1)) + glm::dot(m[1], vec3(1)) + glm::dot(m[2], vec3(1)));
}

std::string text(const vec3& n) {
  return testing::PrintToString(std::vector<float>{n.x, n.y, n.z});
}

TEST(Basis, is_right_handed_around_its_normal_and_orthonormal_but_for_frisvad_and_cross_up) {
  std::set<std::string> held;
  for_each_basis([&](const std::string& name, auto frame) {
    const bool may_fail = name == "rotate-to-normal" || name == "cross-up";
    if (!may_fail) held.insert(name);
    for (const vec3& n : test::hard_directions()) {
      const glm::mat3 m = frame(n);
      ASSERT_EQ(m[2], n) << name;
      ASSERT_TRUE(may_fail || is_finite(m)) << name << " " << text(n);
      if (!is_finite(m)) continue;
      ASSERT_EQ(truth::handedness(m[0], m[1], m[2]), 1.0) << name << " " << text(n);
      // Measured 2.8e-7 for both of Duff's forms, 4.3e-7 for Hughes and Moeller's and 3.9e-7 along u and v; a
      // vector that was made unit in floats is itself off by up to 2e-7.
      ASSERT_TRUE(may_fail || error(m) < 6e-7) << name << " " << text(n) << " " << error(m);
    }
  });
  EXPECT_EQ(held, (std::set<std::string>{"sign-corrected", "duff", "hughes-moller", "uv-aligned"}));
}

TEST(Basis, of_frisvad_is_off_by_0_2_at_a_thousandth_from_minus_z_and_worse_nearer) {
  const auto worst = [](double radius) {
    double most = 0;
    for (int i = 0; i < 4000; ++i) {
      const double angle = 2 * std::numbers::pi * i / 4000, step = 1 + 1e-4 * (i % 50);  // several 1 + n.z
      const double r = radius * step;
      most = std::max(
          most, error(frisvad(vec3(dvec3(r * std::cos(angle), r * std::sin(angle), -std::sqrt(1 - r * r))))));
    }
    return most;
  };
  // With a half rounding d of n.z, n.x^2 / (1 + n.z) is 2 - 2 d / (1 + n.z) where it should be 2, so T's
  // squared length is off by 4 d / (1 + n.z): with d = 2^-25 at most, 2.4e-7 / r^2. The normals' own errors
  // add little.
  for (const double r : {1e-3, 3e-3, 1e-2, 3e-2}) {
    const double expected = 4 * std::ldexp(1.0, -25) / (0.5 * r * r);
    EXPECT_LT(worst(r), 1.2 * expected) << r;
    EXPECT_GT(worst(r), 0.5 * expected) << r;
  }
  EXPECT_NEAR(worst(1e-3), 0.2, 0.05);
  EXPECT_GT(error(frisvad({0.000545734656F, 0, -0.999999881F})), 1.0) << "the nearest place to the limit";
  EXPECT_LT(worst(0.6), 1e-6) << "far away it is as good as the others";
}

TEST(Basis, of_frisvad_takes_z_to_the_normal_by_the_shortest_way_and_is_fixed_at_minus_z) {
  const vec3 n = glm::normalize(vec3(0.3F, -0.5F, 0.7F));
  const vec3 axis = glm::normalize(glm::cross(vec3(0, 0, 1), n));
  // The axis stays where it is: a few roundings.
  EXPECT_LT(glm::distance(frisvad(n) * axis, axis), 3e-7F);
  EXPECT_EQ(frisvad({0, 0, -1}), glm::mat3(0, -1, 0, -1, 0, 0, 0, 0, -1));
}

TEST(Basis, sign_corrected_is_duff_s_and_hughes_and_moeller_s_has_a_bitangent_without_x_or_z) {
  for (const vec3& n : test::hard_directions()) {
    // Both add the same terms, and round them to the same floats.
    for (int i = 0; i < 3; ++i)
      ASSERT_LE(glm::distance(sign_corrected(n)[i], duff(n)[i]), 1.2e-7F) << text(n);
    ASSERT_EQ(std::abs(n.x) > std::abs(n.z) ? hughes_moller(n)[1].z : hughes_moller(n)[1].x, 0.0F) << text(n);
  }
}

TEST(Basis, along_u_and_v_has_the_directions_in_which_the_worksheet_s_coordinates_grow) {
  for (const vec3& n : test::hard_directions()) {
    const glm::mat3 frame = uv_aligned(n);
    EXPECT_EQ(frame[0].y, 0.0F);
    const double from_pole = std::hypot(double{n.x}, double{n.z});
    if (from_pole < 1.01e-16) {
      ASSERT_TRUE(frame[0] == vec3(-1, 0, 0) || from_pole > 0.99e-16) << "the fallback at the poles";
      continue;
    }
    // u = atan(x, z) / -2 pi falls where the longitude grows; v grows with the angle from +y.
    const dvec3 along_u = dvec3(-n.z, 0, n.x) / from_pole;
    const dvec3 down(n.x * n.y / from_pole, -from_pole, n.z * n.y / from_pole);
    // Two roundings of a unit vector.
    ASSERT_LT(test::angle(frame[0], along_u), 2e-7) << text(n);
    ASSERT_LT(test::angle(frame[1], down), 4e-7) << text(n);
  }
}

TEST(Basis, by_a_fixed_up_direction_is_the_same_but_for_the_poles_where_it_is_not_a_number) {
  EXPECT_FALSE(is_finite(cross_up({0, 1, 0})));
  EXPECT_FALSE(is_finite(cross_up({0, -1, 0})));
  for (const vec3& n : test::hard_directions()) {
    // Nearer to a pole its squares lose their digits, and u and v have their fallback.
    if (std::hypot(double{n.x}, double{n.z}) < 1e-15) continue;
    ASSERT_LT(glm::distance(cross_up(n)[0], uv_aligned(n)[0]), 3e-7F) << text(n);
    ASSERT_LT(error(cross_up(n)), 6e-7) << text(n);
  }
}

}  // namespace
}  // namespace texel::answers
