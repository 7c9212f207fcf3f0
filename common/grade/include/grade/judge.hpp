// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <vector>

#include "grade/plan.hpp"
#include "grade/results.hpp"

/// How right one picture (or vertex stream) is: a score from 0, as wrong as what the starter draws, to 1, as
/// right as the limit asks.
namespace texel::grade {

/// What a shot is judged by: files of the shot's size.
struct Expected {
  std::filesystem::path reference;  ///< what the solution draws
  std::filesystem::path mask;       ///< where the object is, as the solution draws it; none for meshes
  /// What earns nothing: as the starter draws it, and the solution without this step. Some may be missing.
  std::vector<std::filesystem::path> worthless;
};

/// How far a picture is from another, in the numbers that the score comes from.
struct Verdict {
  bool passed = false;
  double error = 0;  ///< the largest, but for one pixel of a thousand; NaN where nothing can be compared
  double score = 0;
  std::string message;
};

/// Judges the file `picture`. Whatever it holds, this ends with a verdict: a missing file, one that is no
/// picture, of another size or not finite scores 0. Full marks take that of the object's pixels, and of the
/// background's, no more than one of a thousand differs by more than the limit, where edges may be a pixel
/// off (image::Comparing), and that every pixel is finite. Less is scored by the mean error, over the object
/// or over the background, whichever is worse, as a share of what the starter has there, or of what makes a
/// picture useless; colours by FLIP and by the mean difference, whichever is worse. Vertex streams: by the
/// share of vertices that are right. Throws Error (exit 3) when the expected files cannot be read.
Verdict judge(const Shot& shot, const Expected& expected, const std::filesystem::path& picture);

/// "steps", "degrees", "levels", "texture widths", "units": what a view's error is counted in.
std::string unit_of(const std::string& view);

}  // namespace texel::grade
