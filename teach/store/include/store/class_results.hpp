// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "judge/results.hpp"

/// What grading a class found.
namespace texel::store {

/// What the compiler said of a student's file that it refused, paths shortened to those in the tree.
struct CompilerLog {
  std::string file, text;

  bool operator==(const CompilerLog&) const = default;
};

/// A file of a submission that was not taken.
struct Ignored {
  std::string path;  ///< as text: UTF-8 without control characters
  std::string reason;
};

struct StudentResult {
  std::string id, name, number;  ///< as in Entry: text to be escaped
  std::string fault;             ///< why the submission could not be read, or ""
  std::vector<Ignored> ignored;
  std::vector<CompilerLog> logs;
  std::vector<judge::LabResult> labs;
  std::string incident;  ///< what kept the grader from grading (never a zero: to be tried again), or ""

  std::size_t judged = 0, planned = 0;  ///< cases; fewer are judged than planned while a run is unfinished

  [[nodiscard]] double points() const {
    double sum = 0;
    for (const judge::LabResult& lab : labs) sum += lab.points();
    return sum;
  }
  [[nodiscard]] double max_points() const {
    double sum = 0;
    for (const judge::LabResult& lab : labs) sum += lab.max_points();
    return sum;
  }
  [[nodiscard]] bool is_unfinished() const { return judged < planned; }
  /// Why there is no mark (an incident, or cases that are not judged yet), or "".
  [[nodiscard]] std::string unmarked() const {
    if (!incident.empty() || !is_unfinished()) return incident;
    return "the run is not finished: " + std::to_string(judged) + " of " + std::to_string(planned) +
           " cases are judged";
  }
};

/// A score that a teacher set by hand. It survives regrading.
struct Override {
  std::string student;  ///< id
  std::string step;     ///< "5.1"
  double score = 0;     ///< 0 to 1
  std::string reason;

  bool operator==(const Override&) const = default;
};

/// How a step's score was before the class was graded anew.
struct Change {
  std::string student, step;
  double before = 0, after = 0;
};

/// "together", "alone" or "markers lost".
const char* name_of(judge::Judged judged);
/// Whether one of the step's cases was judged so.
bool is_any(const judge::StepResult& step, judge::Judged judged);

/// Says of each step that was judged alone which others can have spoilt its pictures: those of its lab that
/// did not pass and were begun, and those that it needs.
void name_spoilers(std::vector<judge::LabResult>& labs);

struct ClassResult {
  std::map<std::string, std::string> facts;  ///< renderer, seed's fingerprint, version, command
  std::vector<StudentResult> students;       ///< by id
  std::vector<Change> changes;               ///< of the last regrade; empty after a first one
};

}  // namespace texel::store
