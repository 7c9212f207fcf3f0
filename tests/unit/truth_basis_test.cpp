// SPDX-License-Identifier: MIT
#include "truth/basis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "../support/oracles.hpp"

namespace texel::truth {
namespace {

using glm::dvec3;
using std::numbers::pi;
using test::angle;
using test::angle_in_degrees;
using test::orthonormality;

TEST(TruthAngle, keeps_its_digits_from_tiny_to_straight) {
  for (const double expected : {1e-12, 1e-8, 1e-3, 0.5 * pi, 3.0, pi - 1e-8, pi - 1e-12}) {
    const dvec3 a(0, 0, 1e-6), b(std::sin(expected) * 1e6, 0, std::cos(expected) * 1e6);
    // One rounding of pi is 4.4e-16; the arc cosine would give 0 for the first two.
    EXPECT_NEAR(angle(a, b), expected, 1e-15);
    EXPECT_NEAR(angle_in_degrees(a, b), expected * 180 / pi, 1e-13);
  }
  EXPECT_EQ(angle({1, 2, 3}, {0, 0, 0}), 0.0);
}

TEST(TruthBasis, orthonormality_is_the_largest_entry_of_the_gram_matrix_less_identity) {
  EXPECT_EQ(orthonormality(glm::dmat3(1)), 0.0);
  EXPECT_EQ(orthonormality({dvec3(-1, 0, 0), dvec3(0, 0, 1), dvec3(0, 1, 0)}), 0.0) << "mirrored";
  EXPECT_DOUBLE_EQ(orthonormality({dvec3(2, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)}), 3.0) << "too long";
  EXPECT_DOUBLE_EQ(orthonormality({dvec3(1, 0, 0), dvec3(0.6, 0.8, 0), dvec3(0, 0, 1)}), 0.6) << "leaning";
}

TEST(TruthBasis, handedness_changes_with_every_swap_and_turn) {
  const dvec3 t(2, 0, 0), b(1, 3, 0), n(0, 0, 1);
  EXPECT_EQ(handedness(t, b, n), 1.0);
  EXPECT_EQ(handedness(b, t, n), -1.0);
  EXPECT_EQ(handedness(-t, b, n), -1.0);
  EXPECT_EQ(handedness(t, b, -n), -1.0);
  EXPECT_EQ(handedness(t, -2.0 * t, n), 0.0);
}

TEST(TruthBasis, derivative_of_a_unit_vector_is_what_differences_show) {
  const dvec3 v(0.3, -2, 1.1), dv(0.7, 0.2, -0.4);
  const double step = 1e-5;
  const dvec3 difference = (glm::normalize(v + step * dv) - glm::normalize(v - step * dv)) / (2 * step);
  // The step squared times the third derivative, and 1e-16 / 1e-5 of rounding.
  EXPECT_LT(glm::distance(normalized_derivative(v, dv), difference), 5e-11);
}

}  // namespace
}  // namespace texel::truth
