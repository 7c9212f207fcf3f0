// SPDX-License-Identifier: MIT
// Scores, and which step is to blame.
#include "judge/results.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace texel::judge {
namespace {

CaseResult judged(const std::string& name, double score, bool hidden = false) {
  CaseResult result;
  result.lab = "01_quad";
  result.step = "1.1";
  result.name = name;
  result.hidden = hidden;
  result.score = score;
  result.status = score == 1 ? CaseStatus::passed : CaseStatus::failed;
  if (!result.passed()) result.message = "message of " + name;
  return result;
}

CaseResult looks_like(CaseResult result, const std::string& mistake) {
  result.mistake = mistake;
  result.mistake_says = "this is " + mistake;
  return result;
}

course::Step named_step(const std::string& id, const std::vector<std::string>& needs = {},
                        double points = 1) {
  course::Step step;
  step.id = id;
  step.title = "title of " + id;
  step.points = points;
  step.needs = needs;
  step.hints = {"hint of " + id, "another"};
  return step;
}

course::Lab lab_with(const std::string& folder, const std::vector<course::Step>& steps) {
  course::Lab lab;
  lab.folder = folder;
  lab.steps = steps;
  for (const course::Step& step : steps)
    for (const char* name : {"z of ", "a of "}) {
      course::GradedCase graded;
      graded.name = name + step.id;
      graded.step = step.id;
      lab.cases.push_back(graded);
    }
  return lab;
}

CaseResult judged_in(const std::string& lab, const std::string& step, const std::string& name, double score) {
  CaseResult result = judged(name, score);
  result.lab = lab;
  result.step = step;
  return result;
}

TEST(StepResult, passes_when_all_cases_do) {
  const StepResult result = step_result(named_step("1.1", {}, 2), {judged("a", 1), judged("b", 1, true)});
  EXPECT_EQ(result.status, Status::passed);
  EXPECT_EQ(result.score, 1);
  EXPECT_EQ(result.points, 2);
  EXPECT_EQ(result.id, "1.1");
  EXPECT_EQ(result.title, "title of 1.1");
  EXPECT_EQ(result.hints.at(0), "hint of 1.1");
  EXPECT_EQ(result.message, "");
  EXPECT_EQ(result.mistake, "");
  EXPECT_EQ(result.overridden, "");
  EXPECT_EQ(result.cases.size(), 2U);
}

TEST(StepResult, has_the_mean_of_its_cases_where_all_are_public_or_all_are_hidden) {
  EXPECT_DOUBLE_EQ(step_result(named_step("1.1"), {judged("a", 0.25), judged("b", 1)}).score, 0.625);
  EXPECT_DOUBLE_EQ(step_result(named_step("1.1"), {judged("a", 0.5, true), judged("b", 1, true)}).score,
                   0.75);
}

TEST(StepResult, earns_nothing_by_pictures_made_for_the_public_cases) {
  const StepResult forged =
      step_result(named_step("1.1"), {judged("a", 1), judged("b", 1), judged("c", 1), judged("d", 0, true)});
  EXPECT_EQ(forged.score, 0);
  EXPECT_EQ(forged.status, Status::failed);
}

TEST(StepResult, is_not_lifted_by_its_hidden_cases) {
  EXPECT_DOUBLE_EQ(
      step_result(named_step("1.1"), {judged("a", 0), judged("b", 0.5), judged("c", 1, true)}).score, 0.25);
}

TEST(StepResult, says_what_the_first_failed_case_says) {
  const StepResult result = step_result(
      named_step("1.1"),
      {looks_like(judged("a", 1), "nothing"), judged("b", 0.5), looks_like(judged("e", 1), "nothing"),
       looks_like(judged("c", 0), "flipped"), looks_like(judged("d", 0), "turned")});
  EXPECT_EQ(result.status, Status::failed);
  EXPECT_EQ(result.message, "message of b");
  EXPECT_EQ(result.mistake, "flipped");
  EXPECT_EQ(result.mistake_says, "this is flipped");
}

TEST(StepResult, fails_by_one_case_that_has_not_full_marks_but_nearly) {
  CaseResult nearly = judged("a", 1);
  nearly.status = CaseStatus::failed;
  EXPECT_EQ(step_result(named_step("1.1"), {nearly}).status, Status::failed);
}

TEST(StepResult, fails_with_nothing_where_nothing_was_judged) {
  const StepResult result = step_result(named_step("1.1"), {});
  EXPECT_EQ(result.status, Status::failed);
  EXPECT_EQ(result.score, 0);
  EXPECT_EQ(result.message, "No case of this step was judged.");
}

CaseResult alone(CaseResult result) {
  result.judged = Judged::alone;
  return result;
}

TEST(StepResult, passes_by_cases_that_were_judged_alone) {
  CaseResult spoilt = alone(judged("a", 1));
  spoilt.message = "message of a";
  const StepResult result = step_result(named_step("1.1"), {spoilt, judged("b", 1)});
  EXPECT_EQ(result.status, Status::passed);
  EXPECT_EQ(result.message, "");
  EXPECT_TRUE(result.any(Judged::alone));
  EXPECT_FALSE(result.any(Judged::markers_lost));
}

TEST(LabResults, name_the_steps_that_spoil_one_that_was_judged_alone) {
  const std::vector<course::Lab> labs = {
      lab_with("01_quad", {named_step("1.1"), named_step("1.2", {"1.1"}), named_step("1.3")}),
      lab_with("02_multi", {named_step("2.1", {"1.2"}), named_step("2.2"), named_step("2.3"),
                            named_step("2.4"), named_step("2.5")})};
  CaseResult not_begun = judged_in("02_multi", "2.4", "d", 0);
  not_begun.status = CaseStatus::untouched;
  const std::vector<LabResult> results = lab_results(
      labs, {judged_in("01_quad", "1.1", "a", 0), judged_in("01_quad", "1.2", "b", 1),
             judged_in("01_quad", "1.3", "b", 0), alone(judged_in("02_multi", "2.1", "a", 1)),
             alone(judged_in("02_multi", "2.2", "b", 0.5)), judged_in("02_multi", "2.3", "c", 0.5), not_begun,
             judged_in("02_multi", "2.5", "e", 1)});
  const std::vector<StepResult>& steps = results.at(1).steps;
  // What it needs, through others too, and what was begun in its lab.
  EXPECT_EQ(steps[0].spoilt_by, (std::vector<std::string>{"1.1", "2.2", "2.3"}));
  EXPECT_EQ(steps[1].spoilt_by, (std::vector<std::string>{"2.3"})) << "not the step itself";
  for (const StepResult& other : {steps[2], steps[3], steps[4], results[0].steps[0]})
    EXPECT_TRUE(other.spoilt_by.empty()) << other.id;
}

TEST(LabResults, fail_where_the_steps_that_they_need_failed) {
  const std::vector<course::Lab> labs = {
      lab_with("01_quad", {named_step("1.1"), named_step("1.2", {"1.1"})})};
  const std::vector<StepResult> steps =
      lab_results(labs, {judged_in("01_quad", "1.1", "a", 0), judged_in("01_quad", "1.2", "b", 0)})
          .at(0)
          .steps;
  EXPECT_EQ(steps[1].status, Status::failed);
  EXPECT_EQ(steps[1].message, "message of b");
}

TEST(Needs, are_found_through_others_and_in_the_courses_order) {
  const Needs needs({lab_with("01_quad", {named_step("1.1"), named_step("1.2"), named_step("1.3", {"1.2"})}),
                     lab_with("02_multi", {named_step("2.1", {"1.3", "1.1"})})});
  EXPECT_EQ(needs.of("2.1"), (std::vector<std::string>{"1.1", "1.2", "1.3"}));
  EXPECT_TRUE(needs.of("1.1").empty());
}

TEST(Listed, has_commas_and_an_and) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"1.1"}), "1.1");
  EXPECT_EQ(listed({"1.1", "1.2"}), "1.1 and 1.2");
  EXPECT_EQ(listed({"1.1", "1.2", "1.3"}), "1.1, 1.2 and 1.3");
}

TEST(LabResults, have_the_public_cases_first_in_the_labs_order) {
  const std::vector<course::Lab> labs = {lab_with("01_quad", {named_step("1.1")})};
  CaseResult hidden = judged_in("01_quad", "1.1", "A hidden", 0);
  hidden.hidden = true;
  const std::vector<LabResult> results = lab_results(
      labs, {hidden, judged_in("01_quad", "1.1", "y unknown", 0), judged_in("01_quad", "1.1", "b unknown", 0),
             judged_in("01_quad", "1.1", "a of 1.1", 0), judged_in("01_quad", "1.1", "z of 1.1", 0)});
  std::vector<std::string> names;
  for (const CaseResult& one : results.at(0).steps.at(0).cases) names.push_back(one.name);
  EXPECT_EQ(names, (std::vector<std::string>{"z of 1.1", "a of 1.1", "b unknown", "y unknown", "A hidden"}));
  EXPECT_EQ(results[0].steps[0].message, "message of z of 1.1");
}

TEST(LabResults, leave_out_cases_of_other_labs_and_steps) {
  const std::vector<course::Lab> labs = {lab_with("01_quad", {named_step("1.1")})};
  const std::vector<LabResult> results =
      lab_results(labs, {judged_in("01_quad", "1.1", "a of 1.1", 1), judged_in("01_quad", "1.9", "gone", 0),
                         judged_in("02_multi", "1.1", "elsewhere", 0)});
  ASSERT_EQ(results.at(0).steps.size(), 1U);
  EXPECT_EQ(results[0].steps[0].cases.size(), 1U);
  EXPECT_EQ(results[0].steps[0].status, Status::passed);
}

TEST(LabResults, do_not_depend_on_what_messages_say) {
  const std::vector<course::Lab> labs = {
      lab_with("01_quad", {named_step("1.1"), named_step("1.2", {"1.1"}), named_step("1.3", {"1.2"})})};
  std::vector<CaseResult> cases = {judged_in("01_quad", "1.1", "a", 0), judged_in("01_quad", "1.2", "b", 0.5),
                                   looks_like(judged_in("01_quad", "1.3", "c", 0), "mirrored")};
  resolve(cases[0], {false, 9, 1, "Off."}, "", true);
  const std::vector<StepResult> before = lab_results(labs, cases).at(0).steps;
  EXPECT_EQ(before[0].cases[0].status, CaseStatus::untouched);
  for (CaseResult& one : cases) one.message = "Other words.", one.mistake_says = "Others.";
  const std::vector<StepResult> after = lab_results(labs, cases).at(0).steps;
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(after[i].status, before[i].status) << before[i].id;
    EXPECT_EQ(after[i].score, before[i].score) << before[i].id;
    EXPECT_EQ(after[i].mistake, before[i].mistake) << before[i].id;
  }
}

TEST(Points, are_those_of_the_steps_times_their_scores) {
  const std::vector<LabResult> labs =
      lab_results({lab_with("01_quad", {named_step("1.1", {}, 2), named_step("1.2", {}, 3)})},
                  {judged_in("01_quad", "1.1", "a", 0.25), judged_in("01_quad", "1.2", "b", 1)});
  EXPECT_DOUBLE_EQ(labs[0].points(), 3.5);
  EXPECT_DOUBLE_EQ(labs[0].max_points(), 5);
}

TEST(Status, has_a_name_and_is_found_by_it) {
  EXPECT_STREQ(name_of(Status::passed), "passed");
  EXPECT_STREQ(name_of(Status::failed), "failed");
  EXPECT_STREQ(name_of(Status::skipped), "skipped");
  for (const Status status : {Status::passed, Status::failed, Status::skipped})
    EXPECT_EQ(status_of(name_of(status)), status);
  for (const Judged judged : {Judged::together, Judged::alone, Judged::markers_lost})
    EXPECT_EQ(judged_of(name_of(judged)), judged);
  try {
    status_of("Passed");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), Exit::failed);
    EXPECT_NE(std::string(error.what()).find("'Passed'"), std::string::npos);
  }
}

}  // namespace
}  // namespace texel::judge
