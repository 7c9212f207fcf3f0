// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "course/case.hpp"

/// How right one picture (or vertex stream) is, and what that scores. Files come as their bytes.
namespace texel::judge {

/// What a case is judged by.
struct Expected {
  std::string_view reference;  ///< what the solution draws
  std::string_view mask;       ///< where the object is, as the solution draws it; none for meshes
};

/// How far a picture is from the reference.
struct Verdict {
  bool passed = false;
  double score = 0;  ///< 1 if it passed; 0 where nothing can be compared, or something is not finite
  double error = 0;  ///< the largest, without one pixel of a thousand; NaN where nothing can be compared
  std::string message;
};

/// A case scores nothing from so many times its limit on.
constexpr double kNothingLeft = 5;

/// What a case scores whose error is so many times its limit. Within the limit it is 1. Past it, half is lost
/// at once, and the other half evenly up to five times the limit: twice 0.375, three times 0.25, five times
/// 0. The rule is the same for all steps and units.
double score(double times_limit);

/// Judges a picture; nothing stands for a file that is missing. Whatever it holds, this ends with a verdict,
/// also for one that is no picture, of another size or not finite. To pass, no more than one of a thousand of
/// the object's pixels, and of the background's, differs by more than the limit, where edges may be a pixel
/// off (image::Comparing), and every pixel is finite. Throws Error (exit 3) when what is expected cannot be
/// read.
Verdict judge(const course::Case& of, const Expected& expected, std::optional<std::string_view> picture);

}  // namespace texel::judge
