// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "course/lab_file.hpp"

/// The commands of `texel`, one file each; each returns the exit code or throws Error.
namespace texel::tools {

/// The tree that the programs belong to: TEXEL_ROOT, else beside the program, else the source tree.
std::filesystem::path course_root();
/// The build that this program belongs to.
std::filesystem::path course_build();

/// The labs of the course: from TEXEL_ROOT, else beside the program, else the source tree.
std::vector<course::Lab> course_labs();
/// The labs with these numbers; all for an empty list. Throws Error (usage) for a number without a lab.
std::vector<course::Lab> chosen_labs(const std::vector<int>& numbers);

/// The lab's program in this build.
std::filesystem::path program_of(const course::Lab& lab);
/// Whether the lab's program knows the right answers and draws the view `error`; in a student's tree it does
/// not. Throws Error (exit 3) when the program does not start.
bool knows_truth(const course::Lab& lab);

/// Makes a folder that is missing, with those above it. Throws Error (exit 3).
void make_folder(const std::filesystem::path& folder);

/// `texel list`: the labs at a glance.
Exit list();

struct CompareOptions {
  std::filesystem::path reference, image, mask, heatmap, flip_heatmap;
  std::string unit = "auto";  ///< of two .pfm files: auto, own, degrees or texels
  std::vector<int> texels;    ///< for texels: the texture's width and height, or its one size
  bool edge_tolerance = false;
  std::optional<double> pixels_per_degree;  ///< of FLIP, if not the paper's
  std::optional<double> max, mean, p99, flip;
  bool json = false;
};

/// `texel compare`: how far one picture is from another. Differs when a limit is passed, or a pixel is not
/// finite, or, where no limit is given, when the pictures are not the same.
Exit compare(const CompareOptions& options);

struct GalleryOptions {
  std::filesystem::path out = "out/gallery";
  std::vector<int> labs;         ///< numbers; none for all
  std::filesystem::path heroes;  ///< folder for the heroes, small and 3:2, or none
};

/// `texel gallery`: draws the looks of every lab that changed, and writes the page that shows them.
Exit gallery(const GalleryOptions& options);

/// `texel gallery --list`: prints docs/pictures.md, the sources' pictures with their commands.
Exit list_sources();

struct BenchOptions {
  std::vector<int> labs;                    ///< numbers; none for all
  std::filesystem::path out = "out/bench";  ///< folder for the page and the labs' own figures
  std::filesystem::path json, markdown;     ///< more files to write, or none
  std::filesystem::path from;               ///< an earlier --json to show instead of measuring
  std::filesystem::path against;            ///< an earlier --json whose errors must be the same
  bool errors_only = false;                 ///< no clock
};

/// `texel bench`: error against cost of every method. Differs when an error is not that of `against`.
Exit bench(const BenchOptions& options);

struct MutantsOptions {
  std::filesystem::path catalogue, root, report, work;  ///< empty: those of the course
  std::vector<std::string> only;                        ///< names, or files with names; none for all
};

/// `texel mutants`: makes each mutant of the catalogue in a copy of the tree and runs the tests on it.
/// Differs when they catch fewer than 90 %.
Exit mutants(const MutantsOptions& options);

struct CheckOptions {
  std::vector<int> labs;  ///< numbers; none for all
  bool json = false;
  bool unless_begun = false;  ///< exit code 0 while no step of these labs is begun
  std::string context = "auto";
};

/// `texel check`: which steps of the student's tree are right. Differs when one is not.
Exit check(const CheckOptions& options);

/// `texel progress`: all labs at a glance.
Exit progress(const std::string& context);

struct WatchOptions {
  int lab = 0;
  std::string context = "auto";
};

/// `texel watch`: checks after every save, until 'q' or an interrupt.
Exit watch(const WatchOptions& options);

struct HintOptions {
  std::string where;  ///< a step, a lab's number, or "" for what comes next in the course
  std::string context = "auto";
};

/// `texel hint`: one more hint each time.
Exit hint(const HintOptions& options);

/// `texel reset STEP`: restores a step's starting code, and saves the student's.
Exit reset(const std::string& step);

struct ExpectedCommand {
  std::vector<int> labs;        ///< numbers; none for all
  std::filesystem::path cache;  ///< empty: build/grade of the course
};

/// `texel expected`: draws what `check` compares with.
Exit expected(const ExpectedCommand& command);

struct RenderersCommand {
  std::filesystem::path out = "out/renderers";  ///< folder of the pictures, one for each renderer
  std::filesystem::path cache;                  ///< empty: build/grade of the course
  std::vector<std::string> only;                ///< names of renderers; none for all
  std::filesystem::path json, markdown;         ///< files to write: docs/renderers.json and docs/accuracy.md
  std::string reference = "mesa22_llvmpipe_osmesa";  ///< the folder by which hidden cases are judged
  bool judge_only = false, mutants = false;
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
  std::string shard = "1/1", context = "auto";
  std::vector<std::string> formats;
  bool resume = false, unsafe = false;
};

/// `texel grade CLASS`: grades a class and writes its reports.
Exit grade_class(const GradeCommand& command);

struct GradeMergeCommand {
  std::vector<std::filesystem::path> parts;
  std::filesystem::path out;
  std::vector<std::string> formats;
};

/// `texel grade merge`: joins the results of shards.
Exit grade_merge(const GradeMergeCommand& command);

struct GradeOverrideCommand {
  std::filesystem::path out;
  std::string student, step, reason;
  double score = 0;
  bool drop = false;
  std::vector<std::string> formats;
};

/// `texel grade override`: sets a step's score by hand.
Exit grade_override(const GradeOverrideCommand& command);

struct GradeReportCommand {
  std::filesystem::path out;
  std::vector<std::string> formats;
};

/// `texel grade report`: writes the reports again.
Exit grade_report(const GradeReportCommand& command);

}  // namespace texel::tools
