// SPDX-License-Identifier: MIT
// Assertions on what a renderer draws, which differs a little from one to the next. Where TEXEL_TOLERANCES
// names a folder, a file there says how much of each limit was used: `./run renderers` makes a table of
// these.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <string>

/// value < limit and value > limit, of positive numbers; |value - expected| <= tolerance.
#define EXPECT_BELOW(value, limit) EXPECT_PRED_FORMAT2(::texel::test::is_below, value, limit)
#define EXPECT_ABOVE(value, limit) EXPECT_PRED_FORMAT2(::texel::test::is_above, value, limit)
#define EXPECT_WITHIN(value, expected, tolerance) \
  EXPECT_PRED_FORMAT3(::texel::test::is_within, value, expected, tolerance)
#define ASSERT_BELOW(value, limit) ASSERT_PRED_FORMAT2(::texel::test::is_below, value, limit)
#define ASSERT_WITHIN(value, expected, tolerance) \
  ASSERT_PRED_FORMAT3(::texel::test::is_within, value, expected, tolerance)

namespace texel::test {

/// The largest share of each limit that the tests of this program used, by test and assertion.
struct Tolerances {
  std::map<std::string, double> used;
  ~Tolerances() {
    const char* folder = std::getenv("TEXEL_TOLERANCES");
    if (folder == nullptr) return;
    std::ofstream out(std::filesystem::path(folder) / (std::to_string(::getpid()) + ".tsv"));
    for (const auto& [assertion, share] : used) out << assertion << '\t' << share << '\n';
  }
};

/// Keeps the share, and says what is wrong where it does not hold.
inline testing::AssertionResult used(const std::string& assertion, double share, bool holds, double value,
                                     double limit) {
  static Tolerances all;
  const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
  double& most = all.used[std::string(test.test_suite_name()) + "." + test.name() + "\t" + assertion];
  most = share >= 0 ? std::max(most, share) : std::numeric_limits<double>::infinity();  // NaN is beyond any
  if (holds) return testing::AssertionSuccess();
  return testing::AssertionFailure() << assertion << ", but it is " << value << " beside " << limit;
}

inline testing::AssertionResult is_below(const char* value_text, const char* limit_text, double value,
                                         double limit) {
  return used(std::string(value_text) + " < " + limit_text, value / limit, value < limit, value, limit);
}

inline testing::AssertionResult is_above(const char* value_text, const char* limit_text, double value,
                                         double limit) {
  return used(std::string(value_text) + " > " + limit_text, limit / value, value > limit, value, limit);
}

inline testing::AssertionResult is_within(const char* value_text, const char* expected_text,
                                          const char* tolerance_text, double value, double expected,
                                          double tolerance) {
  const double off = std::abs(value - expected);
  return used(std::string(value_text) + " within " + tolerance_text + " of " + expected_text, off / tolerance,
              off <= tolerance, value, expected);
}

}  // namespace texel::test
