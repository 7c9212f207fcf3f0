// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"

/// The commands of `texel` for who makes or teaches the course. A student's tree does not have them.
namespace texel::commands {

struct BenchOptions {
  std::vector<int> labs;                    ///< numbers; none for all
  std::filesystem::path out = "out/bench";  ///< folder for the page and the labs' own figures
  std::filesystem::path json, markdown;     ///< more files to write, or none
  std::filesystem::path from;               ///< an earlier --json to show instead of measuring
  std::filesystem::path gpu;                ///< another renderer's --json, whose ratios are shown too
  std::filesystem::path against;            ///< an earlier --json whose errors must be the same
  bool errors_only = false;                 ///< no clock
};

/// `texel bench`: error against cost of every method. Differs when an error is not that of `against`.
Exit bench(const BenchOptions& options);

struct ExpectedCommand {
  std::vector<int> labs;        ///< numbers; none for all
  std::filesystem::path cache;  ///< empty: build/grade of the course
};

/// `texel expected`: draws what `check` compares with.
Exit expected(const ExpectedCommand& command);

struct MarksCommand {
  std::vector<int> labs;  ///< numbers; none for all
  int seeds = 3;
  bool places = false;                    ///< no catalogue: only the steps' places as the starter has them
  bool list = false;                      ///< every solution, not only each step's nearest
  std::filesystem::path markdown, cache;  ///< a file to write, or none; empty: build/grade of the course
};

/// `texel marks`: what right and wrong solutions of each step get. Differs when a mistake passes, a right
/// answer fails, or they are less than three times apart.
Exit marks(const MarksCommand& command);

struct RenderersCommand {
  std::filesystem::path out = "out/renderers";  ///< folder of the pictures, one for each renderer
  std::filesystem::path cache;                  ///< empty: build/grade of the course
  std::vector<std::string> only;                ///< names of renderers; none for all
  std::filesystem::path json, markdown;         ///< files to write: docs/renderers.json and docs/accuracy.md
  std::string reference = "mesa22_llvmpipe_osmesa";  ///< the folder by which hidden cases are judged
  bool judge_only = false, mutants = false;
  std::vector<int> labs;  ///< whose mutants are drawn: numbers; none for all
};

/// `texel renderers`: how far the renderers of this machine, and of others whose folders lie in `out`, are
/// from what is expected. Differs when a limit is below three times that; with `mutants`, when a mutant or
/// the starter passes a step by one.
Exit renderers(const RenderersCommand& command);

struct StarterOptions {
  std::filesystem::path out, root;  ///< root empty: the course's own
  std::vector<std::string> solve;   ///< steps that are solved already
  std::filesystem::path pictures;   ///< write nothing else: a folder for a picture of each step
  bool verify = false;              ///< write nothing: check the starter
  std::vector<int> labs;            ///< of those; none for all
  std::filesystem::path cache;      ///< empty: build/grade of the course
};

/// `texel starter`: writes the tree that students start with. With `verify`, differs when a stage between
/// starter and solution passes other steps than those that are solved in it.
Exit starter(const StarterOptions& options);

/// `texel starter --pictures`: draws what each step looks like before and after it is solved, side by side.
/// Throws Error (exit 3) when a stage does not build or draw.
Exit step_pictures(const StarterOptions& options);

struct GradeCommand {
  std::filesystem::path class_folder, out = "out/grades";
  std::filesystem::path cache, seed_file;  ///< empty: build/grade of the course; `out`/seed.txt
  std::vector<int> labs;                   ///< numbers; none for all
  unsigned jobs = 0;                       ///< 0: one for each processor
  std::string shard = "1/1", context = "auto", walls = "namespaces";
  std::vector<std::string> formats;
  bool resume = false, unsafe = false, print_steps = false;
};

/// `texel grade CLASS --print-steps`: prints as JSON what grading takes from each submission: the text of
/// each step that is not the starter's, or of a file whose markers are spoilt the lines that are new; what is
/// not taken, and why. Beside it the solution's steps. Draws nothing and runs no student's program.
Exit print_steps(const GradeCommand& command);

/// `texel grade CLASS`: grades a class and writes its reports.
Exit grade_class(const GradeCommand& command);

struct GradeMergeCommand {
  std::vector<std::filesystem::path> parts;
  std::filesystem::path out;
  std::vector<std::string> formats;
  bool unfinished = false;  ///< students without a mark are no failure
};

/// `texel grade merge`: joins the results of shards. This and the next two throw Error (exit 3) after all is
/// written when the run was cut off, unless `unfinished`.
Exit grade_merge(const GradeMergeCommand& command);

struct GradeOverrideCommand {
  std::filesystem::path out;
  std::string student, step, reason;
  double score = 0;
  bool drop = false, unfinished = false;
  std::vector<std::string> formats;
};

/// `texel grade override`: sets a step's score by hand.
Exit grade_override(const GradeOverrideCommand& command);

struct GradeReportCommand {
  std::filesystem::path out;
  std::vector<std::string> formats;
  bool unfinished = false;
};

/// `texel grade report`: writes the reports again.
Exit grade_report(const GradeReportCommand& command);

/// `texel course NAME …`: a script of teach/commands/scripts, in place of this process. Returns only by an
/// Error: exit 2 for a name that there is not, 3 when the script cannot be started.
Exit run_script(const std::vector<std::string>& words);

}  // namespace texel::commands
