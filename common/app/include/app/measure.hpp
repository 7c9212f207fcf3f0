// SPDX-License-Identifier: MIT
#pragma once
#include "image/image.hpp"

namespace texel::app {

enum class View;

/// In what an error is counted.
enum class Unit {
  degrees,  ///< angle between two directions
  texels,   ///< distance of two texture coordinates
  steps,    ///< largest difference of red, green and blue, in steps of an 8-bit picture
  levels    ///< difference of two levels of detail
};
/// "degrees", "texels", "8-bit steps", "levels"
const char* name_of(Unit unit);

/// What of a lab's picture is compared with which truth.
struct Measure {
  View view;  ///< the data view that holds it; color for 8-bit steps
  Unit unit;
  const char* truth;  ///< what it is compared with, in a few words: "height field on the exact surface"
};

/// What the view should show, from the analytic answer in double precision: RGBA of the picture's size, alpha
/// 1 where there is an answer. Unit vectors for degrees, (s, t) in texels for texels, 8-bit values (not
/// rounded) for steps, levels in red. Empty where the lab's parameters leave the analytic world (an OBJ
/// file).
using Truth = image::ImageF;

/// Mean, root mean square, 99th percentile (nearest rank) and largest value of an error picture.
struct ErrorFigures {
  double mean = 0, rms = 0, p99 = 0, max = 0;
  long long pixels = 0;      ///< compared: both the picture and the truth have a value
  long long non_finite = 0;  ///< of them NaN or infinite in the picture; in none of the other figures
};

/// The error at each pixel in red, alpha 1 where it is known. Where the picture is not finite the error is
/// NaN. Both have the same size and hold what Truth says; the picture's alpha is the object's mask.
image::ImageF error_picture(const image::ImageF& picture, const Truth& truth, Unit unit);

ErrorFigures figures_of(const image::ImageF& error);

/// The smallest of 1, 2 and 5 times a power of ten that is not below `value`: the end of a scale. 1 for 0.
double round_up(double value);

/// The error picture in colours (image::heat; magenta where it is not finite), with a bar that goes from 0 to
/// `scale`.
image::Image8 error_map(const image::ImageF& error, double scale, Unit unit);

}  // namespace texel::app
