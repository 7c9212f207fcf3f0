// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>

#include "course/case.hpp"
#include "image/image.hpp"
#include "params/set.hpp"

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

/// Of an error picture; percentiles by nearest rank. NaN where no pixel has a finite error.
struct ErrorFigures {
  double mean = std::nan(""), rms = mean, median = mean, p99 = mean, max = mean;
  double max_aside = mean;  ///< where each pixel may show what is right one pixel aside: but for outlines
  long long outline_pixels = 0;  ///< whose error is larger than that
  double truth_error = 0;        ///< how far off the right answer itself is, by the samples it is a mean of
  long long truth_pixels = 0;    ///< that have a right answer
  long long pixels = 0;          ///< of these compared: the picture has a value there too
  long long non_finite = 0;      ///< of these NaN or infinite in the picture; in none of the means
  const char* reason = nullptr;  ///< why there are no means, in a sentence; null where there are

  /// The part of the truth that the picture covers, 0 to 1; 1 for no truth.
  [[nodiscard]] double coverage() const {
    return truth_pixels == 0 ? 1 : static_cast<double>(pixels) / static_cast<double>(truth_pixels);
  }
};

/// A picture, compared with the right answer.
struct Measured {
  image::ImageF error;  ///< in red, alpha 1 where it is known; NaN where the picture is not finite
  ErrorFigures figures;
  image::Image8 map;  ///< the error in colours
  double full_scale;  ///< with whose colour they end: the 99th percentile, rounded up to 1, 2 or 5 times 10^n
};

/// What a lab measures at one pixel, as method and truth have it: directions, coordinates, or 8-bit steps of
/// the picture with one sample a pixel.
struct Comparison {
  Measure measure;
  glm::dvec3 value, truth;
  double error;
};

/// What the current look needs once, before its first frame, for this many elements. The benchmark times it.
struct Preparation {
  const char* element;  ///< "triangle"
  std::size_t elements;
  std::function<void()> work;  ///< does it all again
};

class AnyLab;
class Assets;
class Canvas;

/// The right answer of a lab for its present parameters, and what compares pictures with it. A lab that has
/// one has the view `error`. It is linked in with teach/answers: a student's tree has none.
class Answer {
 public:
  virtual ~Answer() = default;
  /// What the view `error` compares.
  [[nodiscard]] virtual Measure measure() const = 0;
  /// Works for about so many milliseconds on the answer for a picture of this size, and returns how much of
  /// it is there, 0 to 1. Throws Error where there is none: for an OBJ file.
  virtual double work(glm::ivec2 size, double milliseconds) = 0;
  /// Draws the lab and compares it with the whole answer.
  [[nodiscard]] virtual Measured measured(Canvas& canvas, glm::ivec2 size) = 0;
  /// Nothing where there is no truth: beside the object, or for a model from a file.
  [[nodiscard]] virtual std::optional<Comparison> compare_at(Canvas& canvas, glm::ivec2 size,
                                                             glm::ivec2 pixel) = 0;
  /// As JSON: {"lab", "parameters", "view", "truth", "truth_error", "unit", "mean", "rms", "median", "p99",
  /// "max", "max_aside", "outline_pixels", "pixels", "truth_pixels", "non_finite"}, and "reason" where there
  /// are no means.
  [[nodiscard]] virtual std::string report(AnyLab& lab, const ErrorFigures& figures) const = 0;
  /// For a lab that has no preparation of its own.
  [[nodiscard]] virtual std::optional<Preparation> preparation(const Assets& /*assets*/) const { return {}; }
};

/// Makes the answer of the lab with these parameters, and adds its own to the set; null where the tree has
/// none.
template <class Parameters>
inline std::unique_ptr<Answer> (*make_answer)(Parameters&, params::Set&) = nullptr;

}  // namespace texel::app
