// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <map>

#include "reports/reports.hpp"
#include "wording.hpp"

namespace texel::reports {
namespace {

/// A cell as it stands: no formula (OWASP, "CSV Injection"; the last four are the full-width signs, which
/// Japanese spreadsheets take as well), and quoted where it has to be, or where a spreadsheet that separates
/// by semicolons would break it.
std::string cell(const std::string& text) {
  constexpr std::array<std::string_view, 11> formulas = {
      "=", "+", "-", "@", "\t", "\r", "\n", "\xEF\xBC\x9D", "\xEF\xBC\x8B", "\xEF\xBC\x8D", "\xEF\xBC\xA0"};
  const bool is_formula = std::any_of(formulas.begin(), formulas.end(),
                                      [&](std::string_view begin) { return text.starts_with(begin); });
  std::string safe = (is_formula ? "'" : "") + text;
  if (safe.find_first_of(",;\"\r\n\t") == std::string::npos) return safe;
  std::string quoted = "\"";
  for (const char c : safe) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Text in one line, as a spreadsheet shows it.
std::string line(const std::string& text) {
  std::string result = clean(text);
  std::replace(result.begin(), result.end(), '\n', ' ');
  return result;
}

std::string row(const std::vector<std::string>& cells) {
  std::string text = cell(cells.front());
  for (std::size_t i = 1; i < cells.size(); ++i) text += "," + cell(cells[i]);
  return text + "\r\n";
}

/// Whether a step of the lab was handed in, or has a score by hand.
bool is_begun(const store::StudentResult& student, const judge::LabResult& lab) {
  return std::any_of(lab.steps.begin(), lab.steps.end(), [&](const judge::StepResult& step) {
    return (student.fault.empty() && !step.is_untouched()) || !step.overridden.empty();
  });
}

/// The steps of each lab that anybody has, in the labs' own order.
std::map<int, std::vector<std::string>> columns(const store::ClassResult& results) {
  std::map<int, std::vector<std::string>> labs;
  for (const store::StudentResult& student : results.students)
    for (const judge::LabResult& lab : student.labs)
      for (const judge::StepResult& step : lab.steps) {
        std::vector<std::string>& steps = labs[lab.lab.number];
        if (std::find(steps.begin(), steps.end(), step.id) == steps.end()) steps.push_back(step.id);
      }
  return labs;
}

}  // namespace

std::string csv(const store::ClassResult& results) {
  const std::map<int, std::vector<std::string>> labs = columns(results);
  std::vector<std::string> head = {"name", "id", "number", "total"};
  for (const auto& [lab, steps] : labs) head.push_back("lab " + std::to_string(lab));
  for (const auto& [lab, steps] : labs)
    for (const std::string& step : steps) head.push_back("step " + line(step));
  head.insert(head.end(), {"begun", "note"});

  std::string text = row(head);
  for (const store::StudentResult& student : results.students) {
    const bool graded = student.unmarked().empty();
    const auto points = [&](double value) { return graded ? number(value, 4) : ""; };
    std::map<int, const judge::LabResult*> by_number;
    for (const judge::LabResult& lab : student.labs) by_number[lab.lab.number] = &lab;

    std::vector<std::string> cells = {line(student.name), student.id, line(student.number),
                                      points(student.points())};
    for (const auto& [lab, steps] : labs)
      cells.push_back(points(by_number.contains(lab) ? by_number[lab]->points() : 0));
    for (const auto& [lab, steps] : labs)
      for (const std::string& id : steps) {
        double value = 0;
        if (by_number.contains(lab))
          for (const judge::StepResult& step : by_number[lab]->steps)
            if (step.id == id) value = step.points * step.score;
        cells.push_back(points(value));
      }
    std::string begun;
    for (const judge::LabResult& lab : student.labs)
      if (graded && is_begun(student, lab))
        begun += (begun.empty() ? "" : " ") + std::to_string(lab.lab.number);
    cells.push_back(begun);
    std::string note = student.fault.empty() ? "" : "the submission " + student.fault;
    if (!graded) note = "not graded: " + student.unmarked();
    for (const judge::LabResult& lab : student.labs)
      for (const judge::StepResult& step : lab.steps)
        if (const std::string told = judging(step); graded && !told.empty())
          note += (note.empty() ? "" : " ") + told;
    cells.push_back(line(note));
    text += row(cells);
  }
  return text;
}

}  // namespace texel::reports
