// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/json.hpp"
#include "course/lab_file.hpp"

/// What the course's makers do with its own tree.
namespace texel::grade {

struct CourseTree {
  std::filesystem::path course, build, cache;  ///< as for GradeOptions
  std::vector<course::Lab> labs;
};

/// Draws the expected pictures of the course's own tree anew, by its solutions, and what its catalogue of
/// mutants looks like. `say` gets a line for each lab. Throws Error (exit 3) when something does not draw.
void write_expected(const CourseTree& options, const std::function<void(const std::string&)>& say);

/// Draws what each step of the labs looks like before and after it is solved, side by side, into a folder:
/// 5.1.png. `say` gets a line for each lab. Throws Error (exit 3) when a lab does not build with some of its
/// steps solved, or does not draw.
void draw_step_pictures(const CourseTree& tree, const std::filesystem::path& folder,
                        const std::function<void(const std::string&)>& say);

// --- Whether marks are earned: what right and wrong solutions of each step get -----------------------------

/// Judges the solution with each place of a step as the starter has it, and, unless `only_places`, each
/// mutant and each equivalent of the catalogues, with so many seeds; or, where a `catalogue` is named, its
/// mutants alone, which have no name. Returns a list of {"step", "name", "is_right", "called", "is_called",
/// "says": {case: sentence}, "seeds": [{"passed", "score", "cases": [{"case", "passed", "error", "limit",
/// "unit"}]}]}: `name` is the entry of the catalogue, or the place; `called` the mistake that the grader
/// takes it for, by the first seed, and `is_called` what it is to be, or both "". `say` gets progress. Throws
/// Error (exit 3) when something does not draw.
Json judged_solutions(const CourseTree& tree, int seeds, const std::filesystem::path& catalogue,
                      bool only_places, const std::function<void(const std::string&)>& say);

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

/// Judges what `draw_cases` wrote into the folders of `drawn` that have a kRendererFile: public cases by the
/// tree's expected pictures, hidden ones by the folder `reference`. Returns a list of {"lab", "case", "unit",
/// "in_pages", "by": {renderer: error}}. `in_pages`: whether a page in a browser judges the case, and so by a
/// graphics card, as public ones of steps in shaders. An error is null where nothing could be compared.
/// Throws Error (exit 3).
Json spreads(const CourseTree& tree, const std::filesystem::path& drawn, const std::string& reference);

}  // namespace texel::grade
