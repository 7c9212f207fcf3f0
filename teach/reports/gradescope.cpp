// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/error.hpp"
#include "lms.hpp"
#include "reports/reports.hpp"

namespace texel::reports {
namespace {

/// What a student reads of a step at once: its public cases, and how many hidden ones failed.
std::string public_output(const judge::StepResult& step) {
  if (step.status == judge::Status::passed) return passed_text(step);
  std::string text = advice(step) + case_lines(step, false);
  if (const std::size_t hidden = count_failed(step.cases, true); hidden > 0)
    text += fmt::format("{} of {} failed.\n", hidden, counted(count(step.cases, true), "hidden case"));
  return text;
}

Json test_of(const judge::StepResult& step, double points, double most, const std::string& output,
             const char* visibility) {
  Json tags = Json::array({name_of(step.status)});
  for (const judge::Judged judged : {judge::Judged::alone, judge::Judged::markers_lost})
    if (step.any(judged)) tags.push_back(name_of(judged));
  if (!step.mistake.empty()) tags.push_back(clean(step.mistake));
  return {{"number", clean(step.id)},
          {"name", clean(step.title)},
          {"score", points},
          {"max_score", most},
          {"status", step.status == judge::Status::passed ? "passed" : "failed"},
          {"output", output},
          {"output_format", "text"},
          {"visibility", visibility},
          {"tags", tags}};
}

}  // namespace

std::string gradescope(const store::StudentResult& student) {
  if (!student.unmarked().empty())
    throw Error::failed(fmt::format("'{}' was not graded: {}", student.id, student.unmarked()), {},
                        "grade again with --resume");
  Json tests = Json::array();
  for (const judge::LabResult& lab : student.labs)
    for (const judge::StepResult& step : lab.steps) {
      tests.push_back(test_of(step, rounded(step.points * step.score), rounded(step.points),
                              public_output(step), "visible"));
      if (count(step.cases, true) == 0) continue;
      // Tests without points may stay hidden: any other hidden test would hide the student's total as well.
      Json hidden = test_of(step, 0, 0, case_lines(step, true), "hidden");
      hidden["name"] = clean(step.title) + " (hidden cases)";
      hidden["status"] = count_failed(step.cases, true) == 0 ? "passed" : "failed";
      tests.push_back(hidden);
    }
  Json results = {{"score", rounded(student.points())},
                  {"output", overview(student)},
                  {"output_format", "text"},
                  {"visibility", "visible"},
                  {"tests", tests}};
  return fitted(results);
}

}  // namespace texel::reports
