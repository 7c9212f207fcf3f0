// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <vector>

#include "grade/plan.hpp"
#include "grade/results.hpp"

/// How right one picture (or vertex stream) is, and what that scores: from 0, as wrong as what the starter
/// draws, to 1, as right as the limit asks.
namespace texel::grade {

/// What a shot is judged by: files of the shot's size.
struct Expected {
  std::filesystem::path reference;  ///< what the solution draws
  std::filesystem::path mask;       ///< where the object is, as the solution draws it; none for meshes
};

/// How far a picture is from the reference.
struct Verdict {
  bool passed = false;
  double error = 0;  ///< the largest, but for one pixel of a thousand; NaN where nothing can be compared
  /// 0 where it passed; else the mean error as a share of what makes a picture useless (of distances, which
  /// have no such share, the mean itself), or the share of wrong vertices. Infinite where nothing can be
  /// compared.
  double wrongness = 0;
  std::string message;
};

/// Judges the file `picture`. Whatever it holds, this ends with a verdict, also for a missing file, one that
/// is no picture, of another size or not finite. To pass, no more than one of a thousand of the object's
/// pixels, and of the background's, differs by more than the limit, where edges may be a pixel off
/// (image::Comparing), and every pixel is finite. The mean error is that over the object or over the
/// background, whichever is worse; of colours by FLIP or by the mean difference, whichever is worse. Throws
/// Error (exit 3) when the expected files cannot be read.
Verdict judge(const Shot& shot, const Expected& expected, const std::filesystem::path& picture);

/// 1 for what passed; less by how wrong it is, as a share of what earns nothing: the `wrongness` of the
/// least wrong of such pictures (what the starter draws, and the solution without the step), infinite where
/// there is none.
double score(const Shot& shot, const Verdict& verdict, double worthless);

/// "steps", "degrees", "levels", "texture widths", "units": what a view's error is counted in.
std::string unit_of(const std::string& view);

}  // namespace texel::grade
