// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "grade/course_tree.hpp"

/// How far renderers are from each other, in the judge's own measure: what a case's limit has to leave room
/// for.
namespace texel::grade {

/// A way to draw that a machine may have.
struct Renderer {
  std::string name;     ///< "softpipe_egl"
  std::string context;  ///< a lab's --context
  std::string says;     ///< what its own name begins with; another driver stood in for it otherwise
  std::vector<std::pair<std::string, std::string>> environment;
};

/// All that we know: llvmpipe by both contexts, with registers of other sizes, the instructions of older
/// processors and their 1/sqrt (`rsqrt_library` displaces it), softpipe, zink, and the machine's GPU.
std::vector<Renderer> known_renderers(const std::filesystem::path& rsqrt_library);

/// Acts with the renderer's variables set; they are unset again afterwards.
void with(const Renderer& renderer, const std::function<void()>& action);

/// Draws all cases by the solutions into `out`/<Mesa's version>_<name>/, hidden ones for each of kSeeds, with
/// kRendererFile, and returns that folder's name; "" where the machine has no such renderer. Throws Error
/// (exit 3) when something does not draw.
std::string draw_by(const Renderer& renderer, const CourseTree& tree, const std::filesystem::path& out);

/// Mutants and starters that a renderer lets pass, with the first seed, a line each. `say` gets progress.
std::vector<std::string> passed_by(const Renderer& renderer, const CourseTree& tree,
                                   const std::function<void(const std::string&)>& say);

/// How far the renderers are from what is expected, in one case.
struct Spread {
  int lab = 0;
  std::string name, unit;
  double limit = 0;
  std::map<std::string, double> by;  ///< by the renderer's folder; NaN where nothing could be compared
  [[nodiscard]] double most() const;
};

/// Judges what `draw_by` wrote: public cases by the tree's expected pictures, hidden ones by the folder
/// `reference`. Throws Error (exit 3).
std::vector<Spread> spreads(const CourseTree& tree, const std::filesystem::path& drawn,
                            const std::string& reference);

}  // namespace texel::grade
