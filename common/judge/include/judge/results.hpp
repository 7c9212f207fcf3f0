// SPDX-License-Identifier: MIT
#pragma once
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "course/lab_file.hpp"
#include "judge/judge.hpp"

/// What judging found: cases, and the steps and labs that follow from them.
namespace texel::grade {

enum class Status {
  passed,
  failed,
  skipped  ///< failed, and a step that it needs failed too: not counted as a mistake of its own
};

/// "passed", "failed", "skipped".
const char* name_of(Status status);
/// The status of that name. Throws Error (exit 3) for another.
Status status_of(const std::string& name);

enum class CaseStatus {
  passed,
  failed,
  untouched  ///< failed, and nothing of its step was written
};

/// "passed", "failed", "untouched".
const char* name_of(CaseStatus status);
/// The status of that name. Throws Error (exit 3) for another.
CaseStatus case_status_of(const std::string& name);

/// One case of one student: the student's picture or vertex stream beside the reference.
struct CaseResult : course::Case {
  CaseResult() = default;
  explicit CaseResult(course::Case of) : Case(std::move(of)) {}

  CaseStatus status = CaseStatus::failed;
  double score = 0;  ///< 0 (as wrong as the starter) to 1 (within the limit)
  double error = std::numeric_limits<double>::quiet_NaN();  ///< as `limit`; NaN: nothing can be compared
  std::string message;       ///< what is wrong, one or two sentences for the student; "" when passed
  std::string mistake;       ///< the name of the mutant that the picture looks like, or ""
  std::string mistake_says;  ///< and its sentence
  std::string command;       ///< draws this picture, typed in the student's tree: "./run lab 5 --turn 50 …"
  std::string picture;  ///< the student's file, relative to the results' folder; "" when there is none or it
                        ///< is as good as the reference
  std::string reference;  ///< the expected one, relative as well; "" where it stays secret

  [[nodiscard]] bool passed() const { return status == CaseStatus::passed; }
  [[nodiscard]] course::Unit unit() const { return course::unit_of(view); }

  bool operator==(const CaseResult&) const = default;
};

/// Fills in what became of a case that was judged. `fault` says why there is no picture, or is "".
void settle(CaseResult& result, const Verdict& verdict, const std::string& fault, bool is_untouched);

struct StepResult {
  std::string id, title;
  double points = 0;  ///< what the step is worth
  double score = 0;   ///< 0 to 1; the teacher's where there is an override
  Status status = Status::failed;
  std::string message;  ///< of the first failed case, or which needed step did not pass; "" when passed
  std::string mistake, mistake_says;  ///< of the first failed case that has one; "" when passed or skipped
  std::vector<std::string> hints;     ///< the step's
  std::string file;                   ///< where the step is written, in the tree
  int line = 0;                       ///< of its first marker in the starter
  std::string overridden;             ///< the teacher's reason for another score, or ""
  std::vector<CaseResult> cases;
};

struct LabResult {
  course::Lab lab;
  std::vector<StepResult> steps;
  std::vector<std::string> notes;  ///< what ended the lab's program early, and the like

  [[nodiscard]] double points() const;      ///< reached
  [[nodiscard]] double max_points() const;  ///< to be reached
};

/// Fills in where each step is written, by its id.
void put_places(std::vector<LabResult>& labs, const std::map<std::string, Place>& places);

/// The case that says most about a step: of those that failed, or of all, the one with the largest share of
/// its limit; one where nothing can be compared before all others. Null when it has none.
const CaseResult* telling_case(const StepResult& step);

/// What those that need a step have to know of it.
struct Before {
  Status status = Status::failed;
  bool is_explained = false;  ///< it failed by a mistake that is known by name, or nothing of it was written
};

/// A step out of its cases. It passed when all of them did, and there is one. Its score is the lower of the
/// means over its public and its hidden cases, so that pictures that were made for the public cases earn
/// nothing; 0 without a case. A step that failed while one of its `needs` did not pass was skipped; but where
/// nothing explains those, and its own pictures show a known mistake, it failed by that: a wrong line spoils
/// pictures of earlier steps too. `before` has the steps before it, by id; a step that is not in it says
/// nothing. `file` and `line` are left to who knows the tree.
StepResult step_result(const course::Step& step, std::vector<CaseResult> cases,
                       const std::map<std::string, Before>& before);

/// All steps of these labs out of one student's cases, in the labs' order. Beyond step_result, a step needs
/// what its needs need, in other labs too, and its message names the first step of the course that is
/// missing; that of a step that nothing explains names the later one whose mistake may be the cause. A step's
/// cases come public ones first, then in the lab file's order, then by name. Cases of other labs or steps are
/// left out.
std::vector<LabResult> lab_results(const std::vector<course::Lab>& labs, std::vector<CaseResult> cases);

}  // namespace texel::grade
