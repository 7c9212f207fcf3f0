// SPDX-License-Identifier: MIT
#include "truth/optics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "../support/oracles.hpp"
#include "procedural/noise.hpp"
#include "truth/surface.hpp"

namespace texel::truth {
namespace {

using glm::dvec3;
using test::angle;

dvec3 unit(int i) {
  return sphere()({procedural::random(i, 0, 17), procedural::random(i, 1, 17)}).position;
}

TEST(TruthOptics, reflecting_twice_changes_nothing_and_angles_are_equal) {
  for (int i = 0; i < 500; ++i) {
    const dvec3 incident = unit(i), normal = unit(i + 1000);
    const dvec3 out = reflected(incident, normal);
    EXPECT_LT(glm::distance(reflected(out, normal), incident), 2e-15);  // a few roundings
    EXPECT_NEAR(angle(out, normal), angle(-incident, normal), 2e-15);
    EXPECT_LT(std::abs(glm::dot(glm::cross(incident, normal), out)), 1e-15) << "in one plane";
    EXPECT_LT(glm::distance(reflected(incident, -normal), out), 1e-15);
  }
}

TEST(TruthOptics, refraction_obeys_snell_stays_in_the_plane_and_can_be_reversed) {
  for (const auto& [n_from, n_to] : {std::pair{1.0, 1.5}, {1.0, 2.42}, {1.33, 1.0}, {1.5, 1.0}, {1.2, 1.2}})
    for (int i = 0; i < 500; ++i) {
      const dvec3 incident = unit(i), normal = unit(i + 1000);
      const auto out = refracted(incident, normal, n_from, n_to);
      const double sin_from = glm::length(glm::cross(incident, normal));
      ASSERT_EQ(out.has_value(), n_from * sin_from <= n_to);
      if (!out) continue;
      EXPECT_NEAR(glm::length(*out), 1, 1e-15);
      EXPECT_NEAR(n_from * sin_from, n_to * glm::length(glm::cross(*out, normal)), 2e-15);
      EXPECT_GT(glm::dot(incident, normal) * glm::dot(*out, normal), 0) << "it goes on";
      const auto back = refracted(-*out, normal, n_to, n_from);
      ASSERT_TRUE(back);
      // The cosine comes from the sine, so a rounding counts by their ratio at grazing incidence: measured
      // 2e-15.
      EXPECT_LT(glm::distance(*back, -incident) * std::abs(glm::dot(incident, normal)), 6e-15);
    }
}

TEST(TruthOptics, total_internal_reflection_begins_at_the_critical_angle) {
  const double critical = std::asin(1 / 1.5);
  const auto at = [](double a) { return dvec3(std::sin(a), -std::cos(a), 0); };
  EXPECT_TRUE(refracted(at(critical - 1e-12), {0, 1, 0}, 1.5, 1.0));
  EXPECT_FALSE(refracted(at(critical + 1e-12), {0, 1, 0}, 1.5, 1.0));
  EXPECT_TRUE(refracted(at(1.57), {0, 1, 0}, 1.0, 1.5)) << "never from the thin side";
}

}  // namespace
}  // namespace texel::truth
