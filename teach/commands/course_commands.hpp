// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "grade/course_tree.hpp"
#include "grade/grader.hpp"

/// The commands of `texel` for who makes or teaches the course. A student's tree does not have them.
namespace texel::commands {

/// The course with some of its labs, or all. `cache` empty: build/grade of the course.
grade::CourseTree course_tree(const std::vector<int>& labs, const std::filesystem::path& cache);

/// `texel expected`: draws what `check` compares with.
Exit expected(const grade::CourseTree& tree);

struct CompareOptions {
  std::filesystem::path reference, image, mask, heatmap;
  bool edge_tolerance = false;
  std::optional<double> max, mean, p99, flip;
  bool json = false;
};

/// `texel compare`: how far one picture is from another. Differs when a limit is passed, or a pixel is not
/// finite, or, where no limit is given, when the pictures are not the same.
Exit compare(const CompareOptions& options);

struct CasesCommand {
  std::string what;                  ///< renderer, draw, batch, mutants, spreads or marks
  std::filesystem::path out, drawn;  ///< a folder or a file for JSON; the renderers' folders
  std::string context = "auto", reference, seed;
  std::vector<int> labs;  ///< numbers; none for all
  int seeds = 3;          ///< of the hidden cases, for marks
  bool places = false;    ///< marks without the catalogue: only the steps' places as the starter has them
  std::filesystem::path cache;  ///< empty: build/grade of the course
};

/// `texel cases WHAT`: what the scripts of this folder ask of the grader.
Exit cases(const CasesCommand& command);

struct StarterOptions {
  std::filesystem::path out;
  std::vector<std::string> solve;  ///< steps that are solved already
  std::filesystem::path pictures;  ///< write nothing else: a folder for a picture of each step
  bool verify = false;             ///< write nothing: check the starter
  std::vector<int> labs;           ///< of those; none for all
  std::filesystem::path cache;     ///< empty: build/grade of the course
};

/// `texel starter`: writes the tree that students start with. With `verify`, differs when a stage between
/// starter and solution passes other steps than those that are solved in it.
Exit starter(const StarterOptions& options);

/// `texel starter --pictures`: draws what each step looks like before and after it is solved, side by side.
/// Throws Error (exit 3) when a stage does not build or draw.
Exit step_pictures(const StarterOptions& options);

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

/// Runs a script of teach/commands in place of this process, which the script finds in the variable TEXEL.
/// Returns only by an Error (exit 3), when it cannot be started.
Exit run_script(const std::filesystem::path& name, const std::vector<std::string>& arguments);

/// `texel course NAME …`: one of teach/commands/scripts. Throws Error (exit 2) for a name that there is not.
Exit run_course_script(const std::vector<std::string>& words);

}  // namespace texel::commands
