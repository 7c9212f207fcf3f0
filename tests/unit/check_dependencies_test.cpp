// SPDX-License-Identifier: MIT
// Which of a student's failed steps comes first, and what is remembered of earlier checks.
#include "../../common/check/dependencies.hpp"

#include <gtest/gtest.h>

#include "../support/picture_files.hpp"
#include "core/files.hpp"

namespace texel::check {
namespace {

using Steps = std::vector<std::string>;

/// A lab whose steps passed or did not, each needing what is said.
judge::LabResult lab(int number, const std::vector<std::pair<std::string, bool>>& steps,
                     const std::map<std::string, Steps>& needs = {}) {
  judge::LabResult result;
  result.lab.number = number;
  for (const auto& [id, passed] : steps) {
    judge::StepResult& step = result.steps.emplace_back();
    step.id = id;
    if (const auto found = needs.find(id); found != needs.end()) step.needs = found->second;
    step.status = passed ? judge::Status::passed : judge::Status::failed;
    if (!passed) step.message = "message of " + id;
  }
  return result;
}

class MemoryTest : public testing::Test {
 protected:
  /// One check: the steps' texts, and which of them passed.
  std::map<std::string, Steps> check(const std::map<std::string, std::string>& texts,
                                     const std::set<std::string>& passed) {
    const auto is = [&](const char* id) { return std::pair<std::string, bool>(id, passed.contains(id)); };
    return changed_since_it_passed(file_, texts, {lab(1, {is("1.3"), is("1.5")}), lab(2, {is("2.1")})});
  }

  test::TemporaryFolder folder_;
  std::filesystem::path file_ = folder_ / "check/passed.json";
};

const std::map<std::string, std::string> kTexts = {{"1.3", "a"}, {"1.5", "b"}, {"2.1", "c"}, {"6.1", "d"}};

std::map<std::string, std::string> with(const std::string& step, const std::string& text) {
  std::map<std::string, std::string> texts = kTexts;
  texts[step] = text;
  return texts;
}

TEST_F(MemoryTest, names_the_steps_that_changed_since_one_passed_until_it_passes_again) {
  EXPECT_TRUE(check(kTexts, {"1.3"}).empty());
  auto texts = with("1.5", "wrong");
  const std::map<std::string, Steps> expected = {{"1.3", {"1.5"}}};
  EXPECT_EQ(check(texts, {}), expected);
  EXPECT_EQ(check(texts, {}), expected) << "nothing was saved";
  texts["6.1"] = "too";
  EXPECT_EQ(check(texts, {}), expected) << "another lab's step cannot spoil it";
  EXPECT_TRUE(check(kTexts, {}).empty()) << "all is as it was";
  EXPECT_TRUE(check(texts, {"1.3"}).empty());
}

TEST_F(MemoryTest, blames_neither_a_step_that_changed_itself_or_never_passed_nor_another_labs_own_step) {
  check(kTexts, {"1.3"});
  EXPECT_TRUE(check(with("2.1", "other"), {}).empty());
  auto texts = with("1.5", "other");
  texts["1.3"] = "other";
  EXPECT_TRUE(check(texts, {}).empty());
}

TEST_F(MemoryTest, is_empty_where_it_is_broken) {
  check(kTexts, {"1.3"});
  write_file(file_, "{ broken");
  EXPECT_TRUE(check(with("1.5", "wrong"), {}).empty());
  EXPECT_TRUE(check(with("1.5", "wrong"), {"1.3"}).empty());
  EXPECT_EQ(check(with("1.5", "again"), {}).size(), 1U) << "and is written anew";
}

TEST(Waiting, skips_what_passed_before_another_step_changed) {
  judge::LabResult first = lab(1, {{"1.3", false}, {"1.5", false}}, {{"1.5", {"1.3"}}});
  skip_those_that_wait(first, {{"1.3", {"1.4", "1.5"}}});
  EXPECT_EQ(first.steps[0].status, judge::Status::skipped);
  EXPECT_EQ(first.steps[0].message, "It passed until you changed 1.4 and 1.5.");
  EXPECT_EQ(first.steps[0].spoilt_by, (Steps{"1.4", "1.5"}));
  EXPECT_EQ(first.steps[1].status, judge::Status::failed) << "1.5 does not wait for 1.3";
  EXPECT_EQ(first.steps[1].message, "message of 1.5");
}

TEST(Waiting, skips_what_needs_a_step_that_did_not_pass) {
  judge::LabResult first =
      lab(1, {{"1.1", false}, {"1.2", true}, {"1.3", false}, {"1.4", false}, {"1.5", true}, {"1.6", false}},
          {{"1.2", {"1.1"}}, {"1.3", {"1.1", "1.2"}}, {"1.5", {"1.1"}}, {"1.6", {"1.1", "1.4"}}});
  skip_those_that_wait(first, {});
  const std::tuple<judge::Status, const char*, Steps> rows[] = {
      {judge::Status::failed, "message of 1.1", {}},
      {judge::Status::passed, "", {}},  // although it needs 1.1
      {judge::Status::skipped, "It needs 1.1 first.", {"1.1"}},
      {judge::Status::failed, "message of 1.4", {}},  // it needs nothing
      {judge::Status::passed, "", {}},
      {judge::Status::skipped, "It needs 1.1 and 1.4 first.", {"1.1", "1.4"}}};
  for (std::size_t i = 0; i < std::size(rows); ++i) {
    const judge::StepResult& step = first.steps[i];
    const auto& [status, message, spoilt_by] = rows[i];
    EXPECT_EQ(step.status, status) << step.id;
    EXPECT_EQ(step.message, message) << step.id;
    EXPECT_EQ(step.spoilt_by, spoilt_by) << step.id;
  }
}

TEST(Waiting, a_program_that_ends_is_the_fault_of_what_was_begun) {
  judge::LabResult first = lab(1, {{"1.1", true}, {"1.2", false}, {"1.3", false}});
  for (std::size_t i : {1, 2}) first.steps[i].cases.emplace_back().died = true;
  first.steps[1].cases[0].status = judge::Status::untouched;
  skip_those_that_wait(first, {});
  EXPECT_EQ(first.steps[1].status, judge::Status::skipped);
  EXPECT_EQ(first.steps[1].spoilt_by, Steps{"1.3"});
  EXPECT_EQ(first.steps[2].status, judge::Status::failed);
}

TEST(Waiting, a_crash_is_the_fault_of_the_step_in_whose_lines_it_happened) {
  judge::LabResult first =
      lab(1, {{"1.1", false}, {"1.2", false}, {"1.3", false}}, {{"1.2", {"1.1"}}, {"1.3", {"1.1", "1.2"}}});
  for (judge::StepResult& step : first.steps) {
    judge::CaseResult& one = step.cases.emplace_back();
    one.died = true, one.message = "crashed at labs/01_a/third.cpp:7", one.crashed_in = "1.3";
  }
  skip_those_that_wait(first, {});
  for (std::size_t i : {0, 1}) {
    EXPECT_EQ(first.steps[i].status, judge::Status::skipped) << "it may be right";
    EXPECT_EQ(first.steps[i].spoilt_by, Steps{"1.3"});
    EXPECT_EQ(first.steps[i].message, "In step 1.3: crashed at labs/01_a/third.cpp:7");
  }
  EXPECT_EQ(first.steps[2].status, judge::Status::failed) << "what it needs is not known to be wrong";
}

TEST(Waiting, does_not_skip_a_known_mistake_while_nothing_explains_what_it_needs) {
  const auto steps_with = [](const std::string& mistake_of_first, bool is_untouched) {
    judge::LabResult first =
        lab(1, {{"1.1", false}, {"1.2", false}, {"1.3", false}}, {{"1.2", {"1.1"}}, {"1.3", {"1.1", "1.2"}}});
    first.steps[0].mistake = mistake_of_first;
    if (is_untouched) first.steps[0].cases.emplace_back().status = judge::Status::untouched;
    first.steps[2].mistake = "flipped";
    skip_those_that_wait(first, {});
    return first.steps;
  };
  const std::vector<judge::StepResult> unexplained = steps_with("", false);
  EXPECT_EQ(unexplained[1].status, judge::Status::skipped);
  EXPECT_EQ(unexplained[2].status, judge::Status::failed);
  EXPECT_EQ(unexplained[2].mistake, "flipped");
  for (const std::vector<judge::StepResult>& steps : {steps_with("mirrored", false), steps_with("", true)}) {
    EXPECT_EQ(steps[2].status, judge::Status::skipped);
    EXPECT_EQ(steps[2].mistake, "") << "it would be counted as one of its own";
  }
}

}  // namespace
}  // namespace texel::check
