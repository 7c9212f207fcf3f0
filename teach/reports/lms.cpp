// SPDX-License-Identifier: MIT
#include "lms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace texel::reports {
namespace {

void shorten(Json& value, std::size_t bytes) {
  for (auto& [key, part] : value.items()) {
    if (part.is_structured())
      shorten(part, bytes);
    else if (part.is_string() && (key == "output" || key == "message"))
      part = shortened(part.get<std::string>(), bytes);
  }
}

}  // namespace

double rounded(double points) {
  return std::round(points * 1e6) / 1e6;
}

std::string overview(const store::StudentResult& student) {
  std::string text =
      fmt::format("{} of {} points.\n", number(student.points()), number(student.max_points()));
  if (!student.fault.empty()) text += "The submission " + clean(student.fault) + "\n";
  for (const judge::LabResult& lab : student.labs)
    for (const std::string& note : lab.notes)
      text += fmt::format("Lab {}: {}\n", lab.lab.number, clean(note));
  for (const store::CompilerLog& log : student.logs)
    text += fmt::format("\n{} does not compile:\n{}\n", clean(log.file), clean(log.text));
  if (!student.ignored.empty()) text += "\nNot used:\n";
  for (const store::Ignored& ignored : student.ignored)
    text += fmt::format("{}: {}\n", clean(ignored.path), clean(ignored.reason));
  return text;
}

std::string passed_text(const judge::StepResult& step) {
  const std::string told = judging(step);
  return told.empty() ? "Passed." : "Passed. " + clean(told);
}

std::string advice(const judge::StepResult& step) {
  std::string text;
  if (const std::string told = judging(step); !told.empty()) text += clean(told) + "\n";
  if (!step.overridden.empty()) text += "The teacher set these points: " + clean(step.overridden) + "\n";
  if (!step.mistake.empty()) text += clean(cause(step.mistake, step.mistake_says)) + "\n";
  if (!step.hints.empty()) text += "Hint: " + clean(step.hints.front()) + "\n";
  if (!step.file.empty()) text += "Written in " + clean(place(step)) + "\n";
  return text;
}

std::string case_lines(const judge::StepResult& step, bool hidden) {
  std::string text;
  for (const judge::CaseResult& result : step.cases) {
    if (result.hidden != hidden) continue;
    text += fmt::format("\n{}: {}\n", clean(result.name),
                        !result.passed()    ? "failed"
                        : result.is_alone() ? "right, only other steps spoil it"
                                            : "passed");
    if (result.passed()) continue;
    if (!result.message.empty()) text += clean(result.message) + "\n";
    if (const std::string off = distance(result); !off.empty()) text += clean(off) + "\n";
    if (result.mistake != step.mistake && !result.mistake.empty())
      text += clean(cause(result.mistake, result.mistake_says)) + "\n";
    if (const std::string typed = command(result); !typed.empty()) text += clean(typed) + "\n";
  }
  return text;
}

std::string fitted(const Json& results) {
  std::string text = to_text(results, 1) + "\n";
  // Halving leaves at least half of what would fit.
  for (std::size_t bytes = kLargestResults / 2; text.size() > kLargestResults; bytes /= 2) {
    if (bytes == 0)
      throw Error::failed("the results are too many for one file", {}, "grade fewer labs at once");
    Json smaller = results;
    shorten(smaller, bytes);
    text = to_text(smaller, 1) + "\n";
  }
  return text;
}

}  // namespace texel::reports
