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
#include "truth/basis.hpp"

namespace texel::answers {
namespace {

using glm::dvec3;
using glm::vec3;

using test::hard_directions;

/// |G - I| of a frame in floats, calculated in double.
double error(const glm::mat3& frame) {
  return test::orthonormality(glm::dmat3(frame));
}

bool is_finite(const glm::mat3& m) {
  for (int i = 0; i < 3; ++i)
    if (!std::isfinite(m[i].x + m[i].y + m[i].z)) return false;
  return true;
}

TEST(Basis, is_orthonormal_to_1e_6_everywhere_but_for_frisvad_and_cross_up) {
  const std::vector<vec3> all = hard_directions();
  std::set<std::string> held;
  for_each_basis([&](const std::string& name, auto frame) {
    if (name == "rotate-to-normal" || name == "cross-up") return;
    held.insert(name);
    double most = 0;
    for (const vec3& n : all) {
      const glm::mat3 m = frame(n);
      ASSERT_TRUE(is_finite(m)) << name << " " << n.x << " " << n.y << " " << n.z;
      most = std::max(most, error(m));
    }
    // Measured 2.8e-7 for both of Duff's forms, 4.3e-7 for Hughes and Moeller's and 3.9e-7 along u and v; a
    // vector that was made unit in floats is itself off by up to 2e-7.
    EXPECT_LT(most, 6e-7) << name;
  });
  EXPECT_EQ(held, (std::set<std::string>{"sign-corrected", "duff", "hughes-moller", "uv-aligned"}));
}

TEST(Basis, is_right_handed_around_the_normal_it_was_given) {
  for (const vec3& n : hard_directions())
    for_each_basis([&](const std::string& name, auto frame) {
      const glm::mat3 m = frame(n);
      EXPECT_EQ(m[2], n) << name;
      if (!is_finite(m)) return;
      ASSERT_EQ(truth::handedness(m[0], m[1], m[2]), 1.0) << name << " " << n.x << " " << n.y << " " << n.z;
    });
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

TEST(Basis, of_frisvad_takes_z_to_the_normal_by_the_shortest_way) {
  const vec3 n = glm::normalize(vec3(0.3F, -0.5F, 0.7F));
  const glm::mat3 rotation = frisvad(n);
  const vec3 axis = glm::normalize(glm::cross(vec3(0, 0, 1), n));
  // The axis stays where it is: a few roundings.
  EXPECT_LT(glm::distance(rotation * axis, axis), 3e-7F);
}

TEST(Basis, of_frisvad_is_a_fixed_one_at_minus_z) {
  EXPECT_EQ(frisvad({0, 0, -1}), glm::mat3(0, -1, 0, -1, 0, 0, 0, 0, -1));
}

TEST(Basis, sign_corrected_is_duff_s) {
  for (const vec3& n : hard_directions()) {
    const glm::mat3 a = sign_corrected(n), b = duff(n);
    // Both add the same terms, and round them to the same floats.
    for (int i = 0; i < 3; ++i)
      ASSERT_LE(glm::distance(a[i], b[i]), 1.2e-7F) << n.x << " " << n.y << " " << n.z;
  }
}

TEST(Basis, of_hughes_and_moeller_has_a_bitangent_without_x_or_z) {
  EXPECT_EQ(hughes_moller(glm::normalize(vec3(0.8F, 0.5F, 0.1F)))[1].z, 0.0F);
  EXPECT_EQ(hughes_moller(glm::normalize(vec3(0.1F, 0.5F, 0.8F)))[1].x, 0.0F);
}

TEST(Basis, along_u_and_v_has_the_directions_in_which_the_worksheet_s_coordinates_grow) {
  for (const vec3& n : hard_directions()) {
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
    ASSERT_LT(test::angle(frame[0], along_u), 2e-7) << n.x << " " << n.y << " " << n.z;
    ASSERT_LT(test::angle(frame[1], down), 4e-7) << n.x << " " << n.y << " " << n.z;
  }
}

TEST(Basis, by_a_fixed_up_direction_is_the_same_but_for_the_poles_where_it_is_not_a_number) {
  EXPECT_FALSE(is_finite(cross_up({0, 1, 0})));
  EXPECT_FALSE(is_finite(cross_up({0, -1, 0})));
  for (const vec3& n : hard_directions()) {
    // Nearer to a pole its squares lose their digits, and u and v have their fallback.
    if (std::hypot(double{n.x}, double{n.z}) < 1e-15) continue;
    const glm::mat3 a = cross_up(n), b = uv_aligned(n);
    ASSERT_LT(glm::distance(a[0], b[0]), 3e-7F) << n.x << " " << n.y << " " << n.z;
    ASSERT_LT(error(a), 6e-7) << n.x << " " << n.y << " " << n.z;
  }
}

}  // namespace
}  // namespace texel::answers
