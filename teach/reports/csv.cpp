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
  const bool is_formula =
      std::ranges::any_of(formulas, [&](std::string_view begin) { return text.starts_with(begin); });
  std::string safe = (is_formula ? "'" : "") + text;
  if (safe.find_first_of(",;\"\r\n\t") == std::string::npos) return safe;
  std::string quoted = "\"";
  for (const char c : safe) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// Text in one line, as a spreadsheet shows it.
std::string line(const std::string& text) {
  std::string result = clean(text);
  std::ranges::replace(result, '\n', ' ');
  return result;
}

std::string row(const std::vector<std::string>& cells) {
  std::string text = cell(cells.front());
  for (std::size_t i = 1; i < cells.size(); ++i) text += "," + cell(cells[i]);
  return text + "\r\n";
}

/// Whether a step of the lab was handed in, or has a score by hand.
bool is_begun(const store::StudentResult& student, const judge::LabResult& lab) {
  return std::ranges::any_of(lab.steps, [&](const judge::StepResult& step) {
    return (student.fault.empty() && !step.is_untouched()) || !step.overridden.empty();
  });
}

std::string column_of(const judge::LabResult& lab) {
  return "lab " + std::to_string(lab.lab.number);
}

std::string column_of(const judge::StepResult& step) {
  return "step " + line(step.id);
}

/// The labs that anybody has, then all their steps in the labs' own order.
std::vector<std::string> columns_of(const store::ClassResult& results) {
  std::map<int, std::vector<std::string>> labs;  // by number: the lab's column and its steps'
  const auto add = [](std::vector<std::string>& columns, const std::string& name) {
    if (std::ranges::count(columns, name) == 0) columns.push_back(name);
  };
  for (const store::StudentResult& student : results.students)
    for (const judge::LabResult& lab : student.labs) {
      add(labs[lab.lab.number], column_of(lab));
      for (const judge::StepResult& step : lab.steps) add(labs[lab.lab.number], column_of(step));
    }
  std::vector<std::string> columns;
  for (const auto& [number, of_lab] : labs) columns.push_back(of_lab.front());
  for (const auto& [number, of_lab] : labs) columns.insert(columns.end(), of_lab.begin() + 1, of_lab.end());
  return columns;
}

}  // namespace

std::string csv(const store::ClassResult& results) {
  const std::vector<std::string> columns = columns_of(results);
  std::vector<std::string> head = {"name", "id", "number", "total"};
  head.insert(head.end(), columns.begin(), columns.end());
  head.insert(head.end(), {"begun", "note"});

  std::string text = row(head);
  for (const store::StudentResult& student : results.students) {
    const bool graded = student.unmarked().empty();
    const auto points = [&](double value) { return graded ? number(value, 4) : ""; };
    std::map<std::string, double> reached;  // by column
    std::string begun, note = student.fault.empty() ? "" : "the submission " + student.fault;
    if (!graded) note = "not graded: " + student.unmarked();
    const auto add_word = [](std::string& to, const std::string& word) {
      if (!word.empty()) to += (to.empty() ? "" : " ") + word;
    };
    for (const judge::LabResult& lab : student.labs) {
      reached[column_of(lab)] = lab.points();
      if (graded && is_begun(student, lab)) add_word(begun, std::to_string(lab.lab.number));
      for (const judge::StepResult& step : lab.steps) {
        reached[column_of(step)] = step.points * step.score;
        if (graded) add_word(note, judging(step));
      }
    }
    std::vector<std::string> cells = {line(student.name), student.id, line(student.number),
                                      points(student.points())};
    for (const std::string& column : columns) cells.push_back(points(reached[column]));
    cells.insert(cells.end(), {begun, line(note)});
    text += row(cells);
  }
  return text;
}

}  // namespace texel::reports
