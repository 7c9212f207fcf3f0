// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "course/lab_file.hpp"
#include "judge/results.hpp"

/// What the course's makers do with its own tree.
namespace texel::grade {

struct CourseTree {
  std::filesystem::path course, build, cache;  ///< as for GradeOptions
  std::vector<course::Lab> labs;
};

/// Draws the expected pictures of the course's own tree anew, by its solutions, and what its catalogue of
/// mutants looks like. `say` gets a line for each lab. Throws Error (exit 3) when something does not draw.
void write_expected(const CourseTree& options, const std::function<void(const std::string&)>& say);

/// Holds the course to what it promises of its starter, lab by lab: as it is it fails every step; with the
/// first k steps solved it passes those k and no other; with all it passes all. Hidden cases count too. What
/// is not so is returned, a line each. `say` gets progress. Throws Error (exit 3) when the starter does not
/// build (a warning is an error there), or something does not draw.
std::vector<std::string> verify_starter(const CourseTree& options,
                                        const std::function<void(const std::string&)>& say);

// --- A lab between starter and solution, as a student has it on the way ------------------------------------

/// The steps that are solved, as "5.1".
using Solved = std::set<std::string>;

/// A lab with some steps solved.
struct Stage {
  std::filesystem::path program;
  std::filesystem::path root;  ///< the folder with shaders/ and assets/
};

/// The lab at each of the stages. Their shaders are written into `folder`, which is empty; their programs are
/// kept in the tree's cache. Throws Error (exit 3) when a stage does not build.
std::map<Solved, Stage> make_stages(const CourseTree& tree, const course::Lab& lab,
                                    const std::vector<Solved>& stages, const std::filesystem::path& folder);

// --- Whether marks are earned: what right and wrong solutions of each step get -----------------------------

struct JudgedSolution {
  std::string name;  ///< the entry of the catalogue, or the place
  bool is_right = false;
  std::vector<judge::StepResult> by_seed;
  /// The mistake that the grader takes it for, by the first seed, and what it is to be; or both "".
  std::string called, is_called;
};

/// Judges the solution with each place of a step as the starter has it, and, unless `only_places`, each
/// mutant and each equivalent of the catalogues, with so many seeds. `say` gets progress. Throws Error
/// (exit 3) when something does not draw.
std::vector<JudgedSolution> judged_solutions(const CourseTree& tree, int seeds, bool only_places,
                                             const std::function<void(const std::string&)>& say);

// --- How far renderers are from each other, in the judge's own measure -------------------------------------
// A case's limit has to leave room for that. Which renderer draws is said by the environment, which
// `./run renderers` sets, and by the labs' `context`.

/// What draws. Throws Error (exit 3) where nothing does.
std::string renderer_here(const CourseTree& tree, const std::string& context);

/// Draws all cases by the solutions into `out`, hidden ones for each of three seeds. Throws Error (exit 3)
/// when something does not draw.
void draw_cases(const CourseTree& tree, const std::string& context, const std::filesystem::path& out);

/// Mutants and starters that pass, with the first seed, a line each. `say` gets progress.
std::vector<std::string> wrongly_passed(const CourseTree& tree, const std::string& context,
                                        const std::function<void(const std::string&)>& say);

/// How far the renderers are from what is expected, in one case.
struct Spread {
  int lab = 0;
  std::string name, unit;
  /// Whether a page in a browser judges the case, and so by a graphics card: public ones of steps in shaders.
  bool is_in_pages = false;
  std::map<std::string, double> by;  ///< by the renderer's folder; NaN where nothing could be compared
};

/// Judges what `draw_cases` wrote into the folders of `drawn` that have a kRendererFile: public cases by the
/// tree's expected pictures, hidden ones by the folder `reference`. Throws Error (exit 3).
std::vector<Spread> spreads(const CourseTree& tree, const std::filesystem::path& drawn,
                            const std::string& reference);

}  // namespace texel::grade
