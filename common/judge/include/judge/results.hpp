// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "course/lab_file.hpp"
#include "judge/judge.hpp"

/// What judging found: cases, and the steps and labs that follow from them.
namespace texel::judge {

enum class Status {
  passed,
  failed,
  skipped,   ///< of a step, only in check: failed, and another comes first; not a mistake of its own
  untouched  ///< of a case: failed, and nothing of its step was written
};

/// What a case's mark is of.
enum class Judged {
  together,     ///< the student's tree
  alone,        ///< the student's step, with the solution standing in for all other steps
  markers_lost  ///< the student's tree: it could not be judged alone, since its markers are damaged
};

/// "passed", "failed", "skipped" or "untouched".
const char* name_of(Status status);
/// The status of that name. Throws Error (exit 3) for another.
Status status_called(const std::string& name);

/// One case of one student: the student's picture or vertex stream beside the reference.
struct CaseResult : course::Case {
  Status status = Status::failed;
  Judged judged = Judged::together;  ///< status, score, error and mistake are of that
  double score = 0;                  ///< 0 (as wrong as the starter) to 1 (within the limit)
  double error = std::numeric_limits<double>::quiet_NaN();  ///< as `limit`; NaN: nothing can be compared
  /// What is wrong in the student's tree, one or two sentences; "" when nothing is.
  std::string message = {};
  std::string mistake = {};       ///< the name of the mutant that the picture looks like, or ""
  std::string mistake_says = {};  ///< and its sentence, or what the values say (Seen), or ""
  std::string command = {};  ///< draws this picture, typed in the student's tree: "./run lab 5 --turn 50 …"
  std::string picture = {};  ///< the student's file, relative to the results' folder; "" when there is none
                             ///< or it is as good as the reference
  std::string reference = {};   ///< the expected one, relative as well; "" where it stays secret
  bool died = false;            ///< the program ended before it was drawn; only in check
  std::string crashed_in = {};  ///< the step in whose lines it ended then, or "": nobody can say

  [[nodiscard]] bool passed() const { return status == Status::passed; }
  [[nodiscard]] bool is_alone() const { return judged == Judged::alone; }
  [[nodiscard]] course::Unit unit() const { return course::unit_of(view); }

  bool operator==(const CaseResult&) const = default;
};

/// Fills in what became of a case that was judged. `fault` says why there is no picture, or is "".
void resolve(CaseResult& result, const Verdict& verdict, const std::string& fault, bool is_untouched);

/// A step, and what became of it.
struct StepResult : course::Step {
  double score = 0;  ///< 0 to 1; the teacher's where there is an override
  Status status = Status::failed;
  std::string message = {};  ///< of the first failed case; of a skipped step, why; "" when passed
  /// Of the first failed case that has a sentence; "" when passed or skipped.
  std::string mistake = {}, mistake_says = {};
  std::string file = {};        ///< where the step is written, in the tree
  int line = 0;                 ///< of its first marker in the starter
  std::int64_t saved = 0;       ///< when a file with its text was last written; only in check
  bool was_right = false;       ///< its text passed before another step was changed; only in check
  std::string overridden = {};  ///< the teacher's reason for another score, or ""
  /// Other steps that did not pass and spoil pictures of this one, as far as is known: where a case was
  /// judged alone, those that it needs and those of its lab that were begun; where check skips it, the step
  /// that comes first.
  std::vector<std::string> spoilt_by = {};
  std::vector<CaseResult> cases = {};

  [[nodiscard]] bool passed() const { return status == Status::passed; }
  /// Whether it failed, and nothing of it was written.
  [[nodiscard]] bool is_untouched() const;
  /// Written, and not right: its own text is to be changed, whether other steps come first or not.
  [[nodiscard]] bool is_wrong() const { return !passed() && !is_untouched() && !was_right; }
};

/// Where to go on: the step that failed and was saved last, else the first that failed, else the first that
/// waits. Null when all passed.
const StepResult* next_step(const std::vector<StepResult>& steps);
/// What those take that did not pass: half an hour a lab and a quarter a point.
double hours_left(const std::vector<StepResult>& steps);

/// A word for the step in a list of its lab's: "done", "waits", "wrong", and of one that is not begun "next"
/// or "to do".
const char* word_of(const StepResult& step, bool is_next);

struct LabResult {
  course::Lab lab;
  std::vector<StepResult> steps;
  std::vector<std::string> notes;  ///< what ended the lab's program early, and the like

  [[nodiscard]] double points() const;      ///< reached
  [[nodiscard]] double max_points() const;  ///< to be reached
};

/// "5.1", "5.1 and 5.2", "5.1, 5.2 and 5.3".
std::string listed(const std::vector<std::string>& steps);

/// Fills in where each step is written, by its id.
void put_places(std::vector<LabResult>& labs, const std::map<std::string, Place>& places);

/// The case that says most about a step: of those that failed, or of all, the one with the largest share of
/// its limit; one where nothing can be compared before all others. Null when it has none.
const CaseResult* clearest_case(const StepResult& step);

/// A step out of its cases. It passed when all of them did, and there is one. Its score is the lower of the
/// means over its public and its hidden cases, so that pictures that were made for the public cases earn
/// nothing; 0 without a case. `file`, `line` and `spoilt_by` are left to who knows the tree and other steps.
StepResult step_result(const course::Step& step, std::vector<CaseResult> cases);

/// All steps of these labs out of one student's cases, in the labs' order. A step's cases come public ones
/// first, then in the lab file's order, then by name. Cases of other labs or steps are left out.
std::vector<LabResult> lab_results(const std::vector<course::Lab>& labs, std::vector<CaseResult> cases);

/// A lab's results as `texel check --json` prints them: {"lab", "title", "steps": [{"id", "status", "error",
/// "unit", "limit", "message", …, "cases": [{"name", "status", "view", "set", …}]}]}. A step's error is that
/// of its clearest_case.
std::string to_json(const LabResult& lab);
/// Of several labs, a list.
std::string to_json(const std::vector<LabResult>& labs);

/// The steps of one lab's results, or of a list of them. Throws Error (exit 3) for any other text.
std::vector<StepResult> parse_steps(const std::string& json);

}  // namespace texel::judge
