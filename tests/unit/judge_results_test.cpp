// SPDX-License-Identifier: MIT
// Scores, which step is to blame, and what is kept and printed of it.
#include "judge/results.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/said.hpp"
#include "core/error.hpp"
#include "course/lab_file.hpp"
#include "store/class_results.hpp"

namespace texel::judge {
namespace {

using Words = std::vector<std::string>;

CaseResult judged(const std::string& name, double score, bool hidden = false) {
  CaseResult result;
  result.lab = "01_quad";
  result.step = "1.1";
  result.name = name;
  result.hidden = hidden;
  result.score = score;
  result.status = score == 1 ? Status::passed : Status::failed;
  if (!result.passed()) result.message = "message of " + name;
  return result;
}

CaseResult looks_like(CaseResult result, const std::string& mistake) {
  result.mistake = mistake;
  result.mistake_says = "this is " + mistake;
  return result;
}

CaseResult alone(CaseResult result) {
  result.judged = Judged::alone;
  return result;
}

course::Step named_step(const std::string& id, const Words& needs = {}, double points = 1) {
  return {id, "title of " + id, points, needs, {"hint of " + id, "another"}};
}

course::Lab lab_with(const std::string& folder, const std::vector<course::Step>& steps) {
  course::Lab lab;
  lab.folder = folder;
  lab.steps = steps;
  for (const course::Step& step : steps)
    for (const char* name : {"z of ", "a of "}) {
      course::Case& graded = lab.cases.emplace_back();
      graded.name = name + step.id;
      graded.step = step.id;
    }
  return lab;
}

CaseResult judged_in(const std::string& lab, const std::string& step, const std::string& name, double score) {
  CaseResult result = judged(name, score);
  result.lab = lab;
  result.step = step;
  return result;
}

TEST(StepResult, has_the_lower_mean_and_what_the_first_failed_case_says) {
  CaseResult nearly = judged("a", 1), spoilt = alone(judged("a", 1));
  nearly.status = Status::failed;
  nearly.message = spoilt.message = "message of a";
  const char* const none = nullptr;
  // `failed` is the case whose message the step has; none where it passed.
  const std::tuple<const char*, double, const char*, const char*, std::vector<CaseResult>> rows[] = {
      {"all passed", 1, none, "", {judged("a", 1), judged("b", 1, true)}},
      {"public cases", 0.625, "a", "", {judged("a", 0.25), judged("b", 1)}},
      {"hidden cases", 0.75, "a", "", {judged("a", 0.5, true), judged("b", 1, true)}},
      {"forged public ones",
       0,
       "d",
       "",
       {judged("a", 1), judged("b", 1), judged("c", 1), judged("d", 0, true)}},
      {"hidden ones lift nothing", 0.25, "a", "", {judged("a", 0), judged("b", 0.5), judged("c", 1, true)}},
      {"the first of each",
       0.25,
       "b",
       "flipped",
       {looks_like(judged("a", 1), "nothing"), judged("b", 0), looks_like(judged("c", 0), "flipped"),
        looks_like(judged("d", 0), "turned")}},
      {"full marks but not passed", 1, "a", "", {nearly}},
      {"judged alone", 1, none, "", {spoilt, judged("b", 1)}}};
  for (const auto& [what, score, failed, mistake, cases] : rows) {
    SCOPED_TRACE(what);
    const StepResult result = step_result(named_step("1.1", {}, 2), cases);
    EXPECT_EQ(result.status, failed == none ? Status::passed : Status::failed);
    EXPECT_DOUBLE_EQ(result.score, score);
    EXPECT_EQ(result.message, failed == none ? "" : std::string("message of ") + failed);
    EXPECT_EQ(result.mistake, mistake);
    EXPECT_EQ(result.mistake_says, result.mistake.empty() ? "" : "this is " + result.mistake);
    EXPECT_EQ(result.cases.size(), cases.size());
  }
  const StepResult nothing = step_result(named_step("1.1", {}, 2), {});
  EXPECT_EQ(nothing.status, Status::failed);
  EXPECT_EQ(nothing.score, 0);
  EXPECT_EQ(nothing.message, "No case of this step was judged.");
  EXPECT_EQ(nothing.points, 2);
  EXPECT_EQ(nothing.id, "1.1");
  EXPECT_EQ(nothing.title, "title of 1.1");
  EXPECT_EQ(nothing.hints.at(0), "hint of 1.1");
  EXPECT_EQ(nothing.overridden, "");
}

TEST(CaseResult, earns_nothing_in_a_step_that_is_as_the_starter_has_it_unless_it_passed) {
  CaseResult result;
  resolve(result, {false, 0.25, 1, "Off."}, "", true);
  EXPECT_EQ(result.status, Status::untouched);
  EXPECT_EQ(result.score, 0);
  EXPECT_EQ(result.message, "This step is still as the starter has it. Off.");
  resolve(result, {false, 0.25, 1, "Off."}, "", false);
  EXPECT_EQ(result.status, Status::failed);
  EXPECT_EQ(result.score, 0.25);
  resolve(result, {true, 1, 0, ""}, "", true);
  EXPECT_EQ(result.status, Status::passed);
  EXPECT_EQ(result.score, 1);
}

TEST(StepResult, is_told_by_the_failed_case_that_is_furthest_beyond_its_limit) {
  const auto off = [](const std::string& name, double error, double limit, double score) {
    CaseResult one = judged(name, score);
    one.error = error, one.limit = limit;
    return one;
  };
  const std::pair<std::vector<CaseResult>, const char*> rows[] = {
      {{off("a", 2, 1, 0), off("b", 3, 2, 0)}, "a"},
      {{off("passed", 0.9, 1, 1), off("b", 0.5, 1, 0)}, "b"},
      {{off("b", 0.5, 1, 0), off("passed", 0.9, 1, 1)}, "b"},
      {{off("first of equal ones", 2, 1, 0), off("b", 2, 1, 0)}, "first of equal ones"},
      {{off("a", 2, 1, 0), off("nothing to compare", std::nan(""), 1, 0)}, "nothing to compare"}};
  for (const auto& [cases, name] : rows)
    EXPECT_EQ(clearest_case(step_result(named_step("1.1"), cases))->name, name);
  EXPECT_EQ(clearest_case({}), nullptr);
}

TEST(LabResults, name_the_steps_that_spoil_one_that_was_judged_alone) {
  CaseResult not_begun = judged("c", 0), needed = not_begun;
  not_begun.step = "1.3", needed.step = "1.4", not_begun.status = needed.status = Status::untouched;
  std::vector<LabResult> results =
      lab_results({lab_with("01_quad", {named_step("1.1", {"1.4"}), named_step("1.2"), named_step("1.3"),
                                        named_step("1.4"), named_step("1.5"), named_step("1.6")}),
                   lab_with("02_multi", {named_step("2.1")})},
                  {alone(judged_in("01_quad", "1.1", "a", 1)), alone(judged_in("01_quad", "1.2", "b", 0.5)),
                   not_begun, needed, judged_in("01_quad", "1.5", "e", 0.5),
                   judged_in("01_quad", "1.6", "f", 1), judged_in("02_multi", "2.1", "g", 0)});
  store::name_spoilers(results);
  const std::vector<StepResult>& steps = results.at(0).steps;
  // What it needs, and what was begun in its lab.
  EXPECT_EQ(steps[0].spoilt_by, (Words{"1.2", "1.4", "1.5"}));
  EXPECT_EQ(steps[1].spoilt_by, Words{"1.5"}) << "not the step itself";
  for (std::size_t i = 2; i < steps.size(); ++i) EXPECT_TRUE(steps[i].spoilt_by.empty()) << steps[i].id;
}

TEST(Listed, has_commas_and_an_and) {
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"1.1"}), "1.1");
  EXPECT_EQ(listed({"1.1", "1.2"}), "1.1 and 1.2");
  EXPECT_EQ(listed({"1.1", "1.2", "1.3"}), "1.1, 1.2 and 1.3");
}

TEST(LabResults, have_the_labs_own_cases_the_public_ones_first_in_its_order) {
  CaseResult hidden = judged_in("01_quad", "1.1", "A hidden", 0);
  hidden.hidden = true;
  const std::vector<LabResult> results = lab_results(
      {lab_with("01_quad", {named_step("1.1")})},
      {hidden, judged_in("01_quad", "1.1", "y unknown", 0), judged_in("01_quad", "1.9", "gone", 0),
       judged_in("01_quad", "1.1", "b unknown", 0), judged_in("01_quad", "1.1", "a of 1.1", 0),
       judged_in("02_multi", "1.1", "elsewhere", 0), judged_in("01_quad", "1.1", "z of 1.1", 0)});
  ASSERT_EQ(results.at(0).steps.size(), 1U);
  Words names;
  for (const CaseResult& one : results[0].steps[0].cases) names.push_back(one.name);
  EXPECT_EQ(names, (Words{"z of 1.1", "a of 1.1", "b unknown", "y unknown", "A hidden"}));
  EXPECT_EQ(results[0].steps[0].message, "message of z of 1.1");
}

TEST(LabResults, do_not_depend_on_what_messages_say) {
  const std::vector<course::Lab> labs = {
      lab_with("01_quad", {named_step("1.1"), named_step("1.2", {"1.1"})})};
  std::vector<CaseResult> cases = {judged_in("01_quad", "1.1", "a", 0),
                                   looks_like(judged_in("01_quad", "1.2", "c", 0.5), "mirrored")};
  resolve(cases[0], {false, 9, 1, "Off."}, "", true);
  std::vector<LabResult> before = lab_results(labs, cases);
  for (CaseResult& one : cases) one.message = "Other words.", one.mistake_says = "Others.";
  const std::vector<LabResult> after = lab_results(labs, cases);
  for (std::size_t i = 0; i < 2; ++i) {
    const StepResult &a = before[0].steps[i], &b = after[0].steps[i];
    EXPECT_EQ(std::tie(a.status, a.score, a.mistake), std::tie(b.status, b.score, b.mistake)) << a.id;
  }
}

TEST(Points, are_those_of_the_steps_times_their_scores) {
  const std::vector<LabResult> labs =
      lab_results({lab_with("01_quad", {named_step("1.1", {}, 2), named_step("1.2", {}, 3)})},
                  {judged_in("01_quad", "1.1", "a", 0.25), judged_in("01_quad", "1.2", "b", 1)});
  EXPECT_DOUBLE_EQ(labs[0].points(), 3.5);
  EXPECT_DOUBLE_EQ(labs[0].max_points(), 5);
}

TEST(PublicCases, are_those_that_are_not_hidden) {
  course::Lab lab = lab_with("01_quad", {named_step("1.1")});
  lab.cases[0].hidden = true;
  const std::vector<course::Case> cases = course::with_public_cases(lab).cases;
  ASSERT_EQ(cases.size(), 1U);
  EXPECT_EQ(cases[0].name, "a of 1.1");
}

TEST(ResultsJson, is_the_same_when_it_was_read_and_written) {
  CaseResult off = looks_like(judged("a of 1.1", 0), "flipped"), nothing = judged("z of 1.1", 0);
  off.error = 0.5, off.limit = 0.25, nothing.error = std::nan("");
  off.view = course::View::normal, off.settings = {{"turn", "30"}}, off.command = "./run lab 1";
  off.picture = "a.png", off.reference = "b.png";
  LabResult lab = lab_results({lab_with("01_quad", {named_step("1.1", {}, 2)})}, {off, nothing}).at(0);
  lab.steps[0].file = "a.cpp", lab.steps[0].line = 7, lab.steps[0].spoilt_by = {"1.2"};
  const std::string text = to_json(lab);
  for (const char* part : {"null", "0.25", "degrees", "turn", "./run lab 1", "b.png", "a.cpp", "\"1.2\"",
                           "this is flipped", "hint of 1.1", "message of z of 1.1"})
    EXPECT_TRUE(test::has(text, part)) << part;
  lab.steps = parse_steps(text);
  EXPECT_EQ(to_json(lab), text);
  EXPECT_EQ(parse_steps(to_json(std::vector{lab, lab})).size(), 2 * lab.steps.size());
  EXPECT_TRUE(test::has(test::error_of([] { parse_steps("Segmentation fault"); }), "did not print its JSON"));
}

TEST(Status, has_a_name_and_is_found_by_it) {
  for (const auto& [status, name] : {std::pair{Status::passed, "passed"},
                                     {Status::failed, "failed"},
                                     {Status::skipped, "skipped"},
                                     {Status::untouched, "untouched"}}) {
    EXPECT_STREQ(name_of(status), name);
    EXPECT_EQ(status_called(name), status);
  }
  EXPECT_TRUE(test::has(test::error_of([] { status_called("Passed"); }), "'Passed'"));
}

}  // namespace
}  // namespace texel::judge
