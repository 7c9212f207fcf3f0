// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "grade/course_tree.hpp"

/// How far renderers are from each other, in the judge's own measure: what a case's limit has to leave room
/// for. Which renderer draws is said by the environment, which `./run renderers` sets, and by the labs'
/// `context`.
namespace texel::grade {

/// What draws, as renderer_of; "" where nothing does.
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
