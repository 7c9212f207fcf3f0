// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "page.hpp"
#include "reports/reports.hpp"
#include "wording.hpp"

namespace texel::reports {
namespace {

/// "8 students. Mean 21.3 of 42 points, median 20. 1 not graded."
std::string summary(const store::ClassResult& results) {
  std::vector<double> points;
  double most = 0;
  for (const store::StudentResult& student : results.students) {
    most = std::max(most, student.max_points());
    if (student.unmarked().empty()) points.push_back(student.points());
  }
  std::string text = counted(results.students.size(), "student") + ".";
  if (const std::size_t n = points.size(); n > 0) {
    std::sort(points.begin(), points.end());
    const double mean = std::accumulate(points.begin(), points.end(), 0.0) / static_cast<double>(n);
    text += fmt::format(" Mean {} of {} points, median {}.", number(mean, 1), number(most),
                        number((points[(n - 1) / 2] + points[n / 2]) / 2, 1));
  }
  if (points.size() < results.students.size())
    text += fmt::format(" {} not graded.", results.students.size() - points.size());
  return text;
}

bool is_nothing_begun(const store::StudentResult& student) {
  return std::ranges::all_of(student.labs, [](const judge::LabResult& lab) {
    return std::ranges::all_of(lab.steps, &judge::StepResult::is_untouched);
  });
}

/// A line below a student's name in the table, and its style; or "".
std::pair<std::string, std::string> note(const store::StudentResult& student) {
  if (!student.incident.empty()) return {"! not graded", "incident"};
  if (student.is_unfinished())
    return {fmt::format("! not finished: {} of {} cases judged", student.judged, student.planned),
            "incident"};
  if (!student.fault.empty() && is_nothing_begun(student)) return {"nothing handed in", "skipped"};
  if (!student.fault.empty()) return {"submission " + student.fault, "failed"};
  if (student.points() == 0 && !student.ignored.empty())
    return {"! 0 points, and files were left out", "failed"};
  // The grader found no step whose mending alone heals the pictures.
  const auto is_right = [](const judge::StepResult& step) {
    return step.status == judge::Status::passed || step.is_untouched();
  };
  for (const judge::LabResult& lab : student.labs)
    if (std::ranges::all_of(lab.steps, is_right) && std::ranges::any_of(lab.steps, [](const auto& step) {
          return store::is_any(step, judge::Judged::alone);
        }))
      return {fmt::format("! lab {}: wrong pictures, and no step lost", lab.lab.number), "failed"};
  return student.logs.empty() ? std::pair("", "") : std::pair("does not compile", "failed");
}

Json student_data(const store::StudentResult& student) {
  Json labs = Json::array();
  for (const judge::LabResult& lab : student.labs) {
    Json steps = Json::array();
    for (const judge::StepResult& step : lab.steps) {
      steps.push_back(step_data(step));
      // Whether the student tried it, and was not kept from it by a fault of the submission.
      steps.back()["begun"] = student.fault.empty() && !step.cases.empty() && !step.is_untouched();
    }
    labs.push_back({{"number", lab.lab.number}, {"title", lab.lab.title}, {"steps", steps}});
  }
  const bool has_mark = student.unmarked().empty();
  const auto [text, style] = note(student);
  return {{"page", page_name(student)},
          {"name", student.name},
          {"number", student.number},
          {"unmarked", student.unmarked()},
          {"readable", student.fault.empty()},
          {"note", text},
          {"noteStyle", style},
          {"points", has_mark ? number(student.points()) : "–"},
          {"sort", has_mark ? student.points() : -1},
          {"labs", labs}};
}

}  // namespace

std::string class_page(const store::ClassResult& results) {
  Json students = Json::array(), changes = Json::array();
  std::map<std::string, const store::StudentResult*> by_id;
  for (const store::StudentResult& student : results.students) {
    by_id[student.id] = &student;
    students.push_back(student_data(student));
  }
  for (const store::Change& change : results.changes) {
    const auto found = by_id.find(change.student);
    const store::StudentResult* student = found == by_id.end() ? nullptr : found->second;
    changes.push_back({{"name", student == nullptr ? change.student : student->name},
                       {"page", student == nullptr ? "" : page_name(*student)},
                       {"step", change.step},
                       {"before", number(100 * change.before, 1)},
                       {"after", number(100 * change.after, 1)},
                       {"rises", change.after > change.before}});
  }
  return page(
      "Class report",
      {{"summary", summary(results)}, {"students", students}, {"changes", changes}, {"facts", results.facts}},
      kClassScript);
}

}  // namespace texel::reports
