// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>

#include "course/case.hpp"
#include "image/image.hpp"

namespace texel::app {

using course::Unit;
using course::View;

/// Which view of a lab is compared with which truth.
struct Measure {
  View view;          ///< the data view that holds it; color for steps
  Unit unit;          ///< degrees, texels, steps or levels
  const char* truth;  ///< what it is compared with, in a few words: "height field on the exact surface"
  double scale = 1;   ///< units for a difference of 1 in the view: texels in a texture's width
  /// Texture coordinates a whole number apart are the same place: on a surface that closes, where a triangle
  /// may lie a pixel off on the other side of the seam. The difference is then taken the short way round.
  bool repeats = false;
};

/// What the view should show at a place of the picture, in pixels from its lower left corner, from the
/// analytic answer in double precision: a unit vector for degrees, (s, t) for texels, 8-bit values (not
/// rounded) for colours, a level in x. Nothing beside the object. May be called by several threads at a time.
/// An empty function if there is no analytic answer (an OBJ file).
using Truth = std::function<std::optional<glm::dvec3>(glm::dvec2 window)>;

/// The truth at the middle of each pixel, RGBA, alpha 1 where there is one and it is finite: the rows from
/// `first` to before `end`, into a picture that is black and transparent there.
void add_truth_rows(image::ImageF& picture, const Truth& truth, int first, int end);

/// Mean, root mean square, 99th percentile (nearest rank) and largest value of an error picture: NaN where no
/// pixel has a finite error.
struct ErrorFigures {
  double mean = std::nan(""), rms = mean, p99 = mean, max = mean;
  long long truth_pixels = 0;  ///< that have a right answer
  long long pixels = 0;        ///< of these compared: the picture has a value there too
  long long non_finite = 0;    ///< of these NaN or infinite in the picture; in none of the means

  /// The part of the truth that the picture covers, 0 to 1; 1 for no truth.
  [[nodiscard]] double coverage() const {
    return truth_pixels == 0 ? 1 : static_cast<double>(pixels) / static_cast<double>(truth_pixels);
  }
};

/// How far two values of the measure's view are apart, in its unit.
double error_of(const glm::dvec3& value, const glm::dvec3& truth, const Measure& measure);

/// The error at each pixel in red, alpha 1 where it is known. Where the picture is not finite the error is
/// NaN. Both have the same size; alpha is 1 where the object is, and where there is a truth.
image::ImageF error_picture(const image::ImageF& picture, const image::ImageF& truth, const Measure& measure);

/// Why there are no means, in a sentence; null where there are.
const char* why_nothing(const ErrorFigures& figures);

/// Of an error picture and the truth that it was made with.
ErrorFigures figures_of(const image::ImageF& error, const image::ImageF& truth);

/// Whether methods are ranked by the root mean square of their errors, in which few pixels that are far off
/// weigh as much as one sees them, and not by the mean: for colours. `unit` as name_of has it.
inline bool ranks_by_rms(std::string_view unit) {
  return unit == name_of(Unit::steps);
}

/// The smallest of 1, 2 and 5 times a power of ten that is not below `value`: the end of a scale. 1 for 0.
double round_up(double value);

/// The error picture in colours (image::heat; magenta where it is not finite), with a bar that goes from 0 to
/// `scale`.
image::Image8 error_map(const image::ImageF& error, double scale, Unit unit);

}  // namespace texel::app
