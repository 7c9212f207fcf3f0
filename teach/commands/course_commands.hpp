// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "commands.hpp"
#include "core/error.hpp"
#include "grade/course_tree.hpp"
#include "grade/grader.hpp"

/// The commands of `texel` for who makes or teaches the course. A student's tree does not have them.
namespace texel::commands {

/// The course with some of its labs, or all. `cache` empty: build/grade of the course.
grade::CourseTree course_tree(const std::vector<int>& labs, const std::filesystem::path& cache);

struct CompareOptions {
  std::filesystem::path reference, image, mask, heatmap;
  std::optional<double> max, mean, p99, flip;
  bool json = false;
};

/// `texel compare`: how far one picture is from another. Differs when a limit is passed, or a pixel is not
/// finite, or, where no limit is given, when the pictures are not the same.
Exit compare(const CompareOptions& options);

/// `course`, `build`, `run` and the shard's numbers are of no account; `cache` empty: build/grade of the
/// course.
struct GradeCommand : grade::GradeOptions {
  std::string part = "1/1", walls = "namespaces";
  std::vector<std::string> formats;
  bool unsafe = false, print_steps = false;
};

/// `texel grade CLASS --print-steps`: prints as JSON what grading takes from each submission: the text of
/// each step that is not the starter's, or of a file whose markers are spoilt the lines that are new; what is
/// not taken, and why. Beside it the solution's steps. Draws nothing and runs no student's program.
Exit print_steps(const GradeCommand& command);

/// `texel grade CLASS`: grades a class and writes its reports.
Exit grade_class(GradeCommand command);

/// Results that were written before, for new reports.
struct EarlierResults {
  std::filesystem::path out;
  std::vector<std::string> formats;
  bool unfinished = false;  ///< students without a mark are no failure
};

/// `texel grade report`: writes the reports again. This and the next two throw Error (exit 3) after all is
/// written when the run was cut off, unless `unfinished`.
Exit grade_report(const EarlierResults& results);

/// `texel grade merge`: joins the results of shards, which lie in `parts`.
Exit grade_merge(const EarlierResults& joined, const std::vector<std::filesystem::path>& parts);

struct GradeOverrideCommand : EarlierResults {
  std::string student, step, reason;
  double score = 0;
  bool drop = false;
};

/// `texel grade override`: sets a step's score by hand.
Exit grade_override(const GradeOverrideCommand& command);

}  // namespace texel::commands
