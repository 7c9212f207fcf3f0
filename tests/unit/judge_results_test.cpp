// SPDX-License-Identifier: MIT
// Scores, and which step is to blame.
#include "judge/results.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace texel::grade {
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
  const StepResult result = step_result(named_step("1.1", {}, 2), {judged("a", 1), judged("b", 1, true)}, {});
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

TEST(StepResult, passes_although_a_needed_step_did_not) {
  EXPECT_EQ(step_result(named_step("1.2", {"1.1"}), {judged("a", 1)}, {{"1.1", {Status::failed}}}).status,
            Status::passed);
}

TEST(StepResult, has_the_mean_of_its_cases_where_all_are_public_or_all_are_hidden) {
  EXPECT_DOUBLE_EQ(step_result(named_step("1.1"), {judged("a", 0.25), judged("b", 1)}, {}).score, 0.625);
  EXPECT_DOUBLE_EQ(step_result(named_step("1.1"), {judged("a", 0.5, true), judged("b", 1, true)}, {}).score,
                   0.75);
}

TEST(StepResult, earns_nothing_by_pictures_made_for_the_public_cases) {
  const StepResult forged = step_result(
      named_step("1.1"), {judged("a", 1), judged("b", 1), judged("c", 1), judged("d", 0, true)}, {});
  EXPECT_EQ(forged.score, 0);
  EXPECT_EQ(forged.status, Status::failed);
}

TEST(StepResult, is_not_lifted_by_its_hidden_cases) {
  EXPECT_DOUBLE_EQ(
      step_result(named_step("1.1"), {judged("a", 0), judged("b", 0.5), judged("c", 1, true)}, {}).score,
      0.25);
}

TEST(StepResult, says_what_the_first_failed_case_says) {
  const StepResult result = step_result(
      named_step("1.1"),
      {looks_like(judged("a", 1), "nothing"), judged("b", 0.5), looks_like(judged("e", 1), "nothing"),
       looks_like(judged("c", 0), "flipped"), looks_like(judged("d", 0), "turned")},
      {});
  EXPECT_EQ(result.status, Status::failed);
  EXPECT_EQ(result.message, "message of b");
  EXPECT_EQ(result.mistake, "flipped");
  EXPECT_EQ(result.mistake_says, "this is flipped");
}

TEST(StepResult, fails_by_one_case_that_has_not_full_marks_but_nearly) {
  CaseResult nearly = judged("a", 1);
  nearly.status = CaseStatus::failed;
  EXPECT_EQ(step_result(named_step("1.1"), {nearly}, {}).status, Status::failed);
}

TEST(StepResult, fails_with_nothing_where_nothing_was_judged) {
  const StepResult result = step_result(named_step("1.1"), {}, {});
  EXPECT_EQ(result.status, Status::failed);
  EXPECT_EQ(result.score, 0);
  EXPECT_EQ(result.message, "No case of this step was judged.");
}

TEST(StepResult, is_skipped_when_a_needed_step_failed_or_was_skipped) {
  for (const Status status : {Status::failed, Status::skipped}) {
    const StepResult result = step_result(named_step("1.3", {"1.1", "1.2"}), {judged("a", 0.5)},
                                          {{"1.1", {Status::passed}}, {"1.2", {status}}});
    EXPECT_EQ(result.status, Status::skipped);
    EXPECT_EQ(result.score, 0.5);
    EXPECT_EQ(result.message, "This step needs step 1.2, which has not passed yet.");
  }
  EXPECT_EQ(step_result(named_step("1.3", {"1.2"}), {}, {{"1.2", {Status::failed}}}).status, Status::skipped);
}

TEST(StepResult, with_a_known_mistake_is_skipped_only_where_something_explains_a_needed_step) {
  const std::vector<CaseResult> cases = {looks_like(judged("a", 0.5), "flipped")};
  const course::Step step = named_step("1.3", {"1.1", "1.2"});
  const StepResult skipped =
      step_result(step, cases, {{"1.1", {Status::failed, true}}, {"1.2", {Status::skipped}}});
  EXPECT_EQ(skipped.status, Status::skipped);
  EXPECT_EQ(skipped.mistake, "") << "it would be counted as one of its own";
  EXPECT_EQ(skipped.cases.at(0).mistake, "flipped");
  const StepResult failed = step_result(step, cases, {{"1.1", {Status::failed}}, {"1.2", {Status::skipped}}});
  EXPECT_EQ(failed.status, Status::failed);
  EXPECT_EQ(failed.mistake, "flipped");
  EXPECT_EQ(failed.message, "message of a");
}

TEST(StepResult, fails_on_its_own_when_its_needs_passed_or_are_unknown) {
  const std::map<std::string, Before> before = {{"1.1", {Status::passed}}, {"1.2", {Status::failed}}};
  EXPECT_EQ(step_result(named_step("1.3", {"1.1", "0.9"}), {judged("a", 0)}, before).status, Status::failed);
}

TEST(LabResults, point_from_a_step_that_nothing_explains_to_the_later_one_that_may_have_spoilt_it) {
  const std::vector<course::Lab> labs = {lab_with(
      "01_quad",
      {named_step("1.1"), named_step("1.2", {"1.1"}), named_step("1.3", {"1.2"}), named_step("1.4")})};
  const auto steps_of = [&](const CaseResult& first) {
    return lab_results(labs, {first, judged_in("01_quad", "1.2", "b", 0),
                              looks_like(judged_in("01_quad", "1.3", "c", 0), "flipped"),
                              judged_in("01_quad", "1.4", "d", 0)})
        .at(0)
        .steps;
  };
  const std::vector<StepResult> unexplained = steps_of(judged_in("01_quad", "1.1", "a", 0));
  EXPECT_EQ(unexplained[0].message,
            "message of a The cause may be in step 1.3: its pictures show a known mistake.");
  EXPECT_EQ(unexplained[1].status, Status::skipped);
  EXPECT_EQ(unexplained[2].status, Status::failed);
  EXPECT_EQ(unexplained[2].message, "message of c");
  EXPECT_EQ(unexplained[3].message, "message of d") << "1.3 does not need it";

  CaseResult untouched = judged_in("01_quad", "1.1", "a", 0);
  untouched.status = CaseStatus::untouched;
  const CaseResult named = looks_like(judged_in("01_quad", "1.1", "a", 0), "mirrored");
  for (const CaseResult& first : {untouched, named}) {
    const std::vector<StepResult> steps = steps_of(first);
    EXPECT_EQ(steps[0].message, first.message);
    EXPECT_EQ(steps[2].status, Status::skipped);
    EXPECT_EQ(steps[2].mistake, "");
  }
}

TEST(LabResults, find_the_first_missing_step_through_others_and_in_other_labs) {
  const std::vector<course::Lab> labs = {
      lab_with("01_quad", {named_step("1.1"), named_step("1.2", {"1.1"})}),
      lab_with("02_multi", {named_step("2.1", {"1.2"}), named_step("2.2", {"2.1"}), named_step("2.3")})};
  const std::vector<LabResult> results = lab_results(
      labs, {judged_in("02_multi", "2.2", "a of 2.2", 0), judged_in("02_multi", "2.1", "a of 2.1", 1),
             judged_in("01_quad", "1.2", "a of 1.2", 1), judged_in("01_quad", "1.1", "a of 1.1", 0),
             judged_in("02_multi", "2.3", "a of 2.3", 0)});
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].lab.folder, "01_quad");
  EXPECT_EQ(results[0].steps.at(0).status, Status::failed);
  EXPECT_EQ(results[0].steps.at(1).status, Status::passed);
  EXPECT_EQ(results[1].steps.at(0).status, Status::passed);
  // 2.2 needs 2.1, which passed, and so 1.1, which did not.
  EXPECT_EQ(results[1].steps.at(1).status, Status::skipped);
  EXPECT_EQ(results[1].steps.at(1).message, "This step needs step 1.1, which has not passed yet.");
  EXPECT_EQ(results[1].steps.at(2).status, Status::failed);
}

TEST(LabResults, name_the_cause_and_not_a_step_that_was_skipped_for_it) {
  const std::vector<course::Lab> labs = {lab_with(
      "01_quad", {named_step("1.1"), named_step("1.2", {"1.1"}), named_step("1.3", {"1.2", "1.1"})})};
  const std::vector<LabResult> results = lab_results(labs, {});
  EXPECT_EQ(results.at(0).steps.at(1).status, Status::skipped);
  EXPECT_EQ(results.at(0).steps.at(2).message, "This step needs step 1.1, which has not passed yet.");
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
  settle(cases[0], {false, 9, 1, "Off."}, "", true);
  const std::vector<StepResult> before = lab_results(labs, cases).at(0).steps;
  EXPECT_EQ(before[0].cases[0].status, CaseStatus::untouched);
  EXPECT_EQ(before[1].status, Status::skipped) << "1.1 was not begun";
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
  try {
    status_of("Passed");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.exit_code(), Exit::failed);
    EXPECT_NE(std::string(error.what()).find("'Passed'"), std::string::npos);
  }
}

}  // namespace
}  // namespace texel::grade
