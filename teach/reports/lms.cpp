// SPDX-License-Identifier: MIT
// Files for the systems that keep marks, Gradescope and PrairieLearn: plain text, and a limit of size.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/json.hpp"
#include "pictures.hpp"
#include "reports/reports.hpp"
#include "wording.hpp"

namespace texel::reports {
namespace {

/// Both systems say "1 MB"; this is its smaller reading.
constexpr std::size_t kLargest = 1'000'000;

/// A number of points without the noise of sums: to 6 decimals.
double rounded(double points) {
  return std::round(points * 1e6) / 1e6;
}

/// Adds a line, cleaned, unless it is empty.
void add_line(std::string& text, const std::string& line) {
  if (!line.empty()) text += clean(line) + "\n";
}

/// Of the whole submission: the points, what the compiler refused, what was not taken.
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

/// "Passed.", and how the step was judged where its pictures are wrong all the same.
std::string passed_text(const judge::StepResult& step) {
  const std::string told = judging(step);
  return told.empty() ? "Passed." : "Passed. " + clean(told);
}

/// How the step was judged, the likely cause, the hint and the place of a step.
std::string advice(const judge::StepResult& step) {
  std::string text;
  add_line(text, judging(step));
  if (!step.overridden.empty()) add_line(text, "The teacher set these points: " + step.overridden);
  add_line(text, cause(step.mistake_says));
  if (!hint(step).empty()) add_line(text, "Hint: " + hint(step));
  if (!step.file.empty()) add_line(text, "Written in " + place(step));
  return text;
}

/// A line or more for each of the step's public or hidden cases.
std::string case_lines(const judge::StepResult& step, bool hidden) {
  std::string text;
  for (const judge::CaseResult& result : step.cases) {
    if (result.hidden != hidden) continue;
    text += fmt::format("\n{}: {}\n", clean(result.name),
                        !result.passed()    ? "failed"
                        : result.is_alone() ? "right, only other steps spoil it"
                                            : "passed");
    if (result.passed()) continue;
    add_line(text, result.message);
    add_line(text, distance(result));
    if (result.mistake_says != step.mistake_says) add_line(text, cause(result.mistake_says));
    add_line(text, command(result));
  }
  return text;
}

void shorten(Json& value, std::size_t bytes) {
  for (auto& [key, part] : value.items()) {
    if (part.is_structured())
      shorten(part, bytes);
    else if (part.is_string() && (key == "output" || key == "message"))
      part = shortened(part.get<std::string>(), bytes);
  }
}

/// The results as text of at most kLargest bytes: every "output" and "message" is cut to the same length, as
/// long as fits.
std::string fitted(const Json& results) {
  std::string text = to_text(results, 1) + "\n";
  // Halving leaves at least half of what would fit.
  for (std::size_t bytes = kLargest / 2; text.size() > kLargest; bytes /= 2) {
    if (bytes == 0)
      throw Error::failed("the results are too many for one file", {}, "grade fewer labs at once");
    Json smaller = results;
    shorten(smaller, bytes);
    text = to_text(smaller, 1) + "\n";
  }
  return text;
}

/// What a student reads of a step at once: its public cases, and how many hidden ones failed.
std::string public_output(const judge::StepResult& step) {
  if (step.status == judge::Status::passed) return passed_text(step);
  std::string text = advice(step) + case_lines(step, false);
  if (const std::size_t hidden = count(step.cases, true, true); hidden > 0)
    text += fmt::format("{} of {} failed.\n", hidden, counted(count(step.cases, true), "hidden case"));
  return text;
}

Json test_of(const judge::StepResult& step, double points, double most, const std::string& output,
             const char* visibility) {
  Json tags = Json::array({name_of(step.status)});
  for (const judge::Judged judged : {judge::Judged::alone, judge::Judged::markers_lost})
    if (store::is_any(step, judged)) tags.push_back(store::name_of(judged));
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

/// How much of the file is kept for text, in bytes: pictures may have the rest.
constexpr std::size_t kForText = kLargest / 4;

Json not_gradable(const std::string& message) {
  return {{"gradable", false}, {"message", message}, {"format_errors", Json::array({message})}};
}

/// The pictures of a step's failed cases, until one does not fit into the bytes that are left, which ends it:
/// those of the first failing steps matter most.
Json images_of(const judge::StepResult& step, const Pictures& pictures, std::size_t& left) {
  Json images = Json::array();
  for (const judge::CaseResult& result : step.cases) {
    if (result.passed() || result.is_mesh()) continue;
    for (const auto& [path, whose] : {std::pair(result.picture, "yours"), {result.reference, "expected"}}) {
      if (path.empty() || left == 0) continue;
      const Picture picture = pictures.read(path, name_of(result.view));
      if (picture.url.empty()) continue;
      const std::size_t bytes = picture.url.size() + 200;  // with its label and the JSON around it
      if (bytes <= left)
        images.push_back({{"label", fmt::format("{}, {}", clean(result.name), whose)}, {"url", picture.url}});
      left -= std::min(bytes, left);
    }
  }
  return images;
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
      hidden["status"] = count(step.cases, true, true) == 0 ? "passed" : "failed";
      tests.push_back(hidden);
    }
  Json results = {{"score", rounded(student.points())},
                  {"output", overview(student)},
                  {"output_format", "text"},
                  {"visibility", "visible"},
                  {"tests", tests}};
  return fitted(results);
}

std::string prairielearn(const store::StudentResult& student, const std::filesystem::path& folder) {
  if (!student.incident.empty()) return fitted(not_gradable(kIncident));
  if (student.is_unfinished()) return fitted(not_gradable("Not graded yet: " + student.unmarked() + "."));
  if (!student.fault.empty()) return fitted(not_gradable("The submission " + clean(student.fault)));

  Json tests = Json::array();
  std::vector<const judge::StepResult*> steps;
  for (const judge::LabResult& lab : student.labs)
    for (const judge::StepResult& step : lab.steps) {
      steps.push_back(&step);
      const bool passed = step.status == judge::Status::passed;
      tests.push_back(
          {{"name", clean(step.id + " " + step.title)},
           {"points", rounded(step.points * step.score)},
           {"max_points", rounded(step.points)},
           {"message", passed ? passed_text(step) : clean(step.message)},
           {"output", passed ? "" : advice(step) + case_lines(step, false) + case_lines(step, true)}});
    }
  const double most = student.max_points();
  Json results = {{"gradable", true},
                  {"score", most > 0 ? std::clamp(rounded(student.points() / most), 0.0, 1.0) : 0},
                  {"message", fmt::format("{} of {} points.", number(student.points()), number(most))},
                  {"output", overview(student)},
                  {"images", Json::array()},
                  {"tests", tests}};

  const Pictures pictures(folder);
  std::size_t left = kLargest - std::max(fitted(results).size(), kForText);
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (Json found = images_of(*steps[i], pictures, left); !found.empty())
      results["tests"][i]["images"] = std::move(found);
  return fitted(results);
}

}  // namespace texel::reports
