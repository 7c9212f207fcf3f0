// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "course/case.hpp"

/// How right one picture (or vertex stream) is, and what that scores: from 0, as wrong as what the starter
/// draws, to 1, as right as the limit asks. Files come as their bytes.
namespace texel::grade {

/// What a case is judged by.
struct Expected {
  std::string_view reference;  ///< what the solution draws
  std::string_view mask;       ///< where the object is, as the solution draws it; none for meshes
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

/// Judges a picture; nothing stands for a file that is missing. Whatever it holds, this ends with a verdict,
/// also for one that is no picture, of another size or not finite. To pass, no more than one of a thousand of
/// the object's pixels, and of the background's, differs by more than the limit, where edges may be a pixel
/// off (image::Comparing), and every pixel is finite. The mean error is that over the object or over the
/// background, whichever is worse; of colours by FLIP or by the mean difference, whichever is worse. Throws
/// Error (exit 3) when what is expected cannot be read.
Verdict judge(const course::Case& of, const Expected& expected, std::optional<std::string_view> picture);

/// 1 for what passed; less by how wrong it is, as a share of what earns nothing: the `wrongness` of the
/// least wrong of such pictures (what the starter draws, and the solution without the step), infinite where
/// there is none.
double score(const course::Case& of, const Verdict& verdict, double worthless);

}  // namespace texel::grade
