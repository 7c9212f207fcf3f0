// SPDX-License-Identifier: MIT
// `texel marks`: each mistake loses marks, each right answer has them all.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "../support/places.hpp"
#include "../support/process.hpp"
#include "../support/said.hpp"
#include "core/files.hpp"
#include "course/lab_file.hpp"
#include "course/markers.hpp"

namespace texel {
namespace {

using test::has;
using test::Result;

Result marks(const std::string& arguments) {
  return test::shell(
      fmt::format("{}/texel marks {} --cache '{}/grade'", test::kBin, arguments, test::kBuild));
}

TEST(Marks, are_lost_with_any_place_of_a_step_left_as_the_starter_has_it) {
  const Result result = marks("--places --seeds 2 --list");
  EXPECT_EQ(result.exit_code, 0) << result.output << result.errors;
  std::map<std::string, int> places;
  for (const std::string& file : course::step_files(test::kSource))
    for (const course::Marker& marker :
         course::markers_of(read_file(std::filesystem::path(test::kSource) / file), file))
      if (!marker.step.empty()) {
        EXPECT_TRUE(has(result.output,
                        fmt::format("place-{}-of-{}-as-in-the-starter", ++places[marker.step], marker.step)));
      }
  EXPECT_EQ(places["9.3"], 2);
}

/// The seed moves cameras and values and chooses pictures. What a student writes for each value of a choice
/// has cases of its own: else the seed would decide whether a mistake is looked for.
TEST(HiddenCases, let_the_seed_choose_no_way_that_a_step_must_write) {
  const std::set<std::string> pictures = {"texture", "texture0",   "texture1",
                                          "model",   "normal_map", "cube_map"};
  // Given in the lab's code; the step is the same for all of their values.
  const std::set<std::string> given = {"2.1 method", "6.3 method", "7.3 precision", "8.2 normal_method",
                                       "9.4 incident"};
  for (const course::Lab& lab : course::read_labs(std::filesystem::path(test::kSource) / "labs"))
    for (const course::GradedCase& one : lab.cases)
      for (const course::Hidden& hidden : one.hidden_settings) {
        const bool are_numbers = std::all_of(
            hidden.values.begin(), hidden.values.end(),
            [](const std::string& value) { return value.find_first_not_of("0123456789.") == value.npos; });
        EXPECT_TRUE(are_numbers || pictures.contains(hidden.parameter) ||
                    given.contains(one.step + " " + hidden.parameter))
            << lab.folder << " " << one.name << ": " << hidden.parameter;
      }
}

/// The other labs' mistakes are in C++: compiling them takes minutes.
class MarksOfLab : public testing::TestWithParam<int> {};

TEST_P(MarksOfLab, are_lost_by_each_mistake_and_kept_by_each_right_answer) {
  const bool is_quick = GetParam() == 8 || GetParam() == 9;
  if (!is_quick && std::getenv("TEXEL_TEST_ALL") == nullptr) GTEST_SKIP() << "./run test --all";
  const Result result = marks(fmt::format("{} --seeds 2", GetParam()));
  EXPECT_EQ(result.exit_code, 0) << result.output << result.errors;
}

INSTANTIATE_TEST_SUITE_P(Lab, MarksOfLab, testing::Range(1, 10));

}  // namespace
}  // namespace texel
