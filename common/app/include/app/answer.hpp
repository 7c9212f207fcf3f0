// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

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

/// What the view should show at a place of the picture, in pixels from its lower left corner, from the
/// analytic answer in double precision: a unit vector for degrees, (s, t) for texels, 8-bit values (not
/// rounded) for colours, a level in x. Nothing beside the object. May be called by several threads at a time.
/// An empty function if there is no analytic answer (an OBJ file).
using Truth = std::function<std::optional<glm::dvec3>(glm::dvec2 window)>;

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
  double full_scale;  ///< with whose colour they end
};

class AnyLab;

/// What compares a lab's pictures with its right answer. It is linked in with the answers (teach/answers), so
/// a student's tree has none. It keeps the answer of the last look.
class Measuring {
 public:
  virtual ~Measuring() = default;
  /// As Canvas::work_on_truth, for a lab with an answer.
  virtual double work_on_truth(AnyLab& lab, glm::ivec2 size, double milliseconds) = 0;
  /// Compares the values of the measure's view with the answer that is worked out. The colours of the map end
  /// at `scale`; 0 as for Canvas::set_error_scale.
  [[nodiscard]] virtual Measured measured(const image::ImageF& picture, const Measure& measure,
                                          double scale) const = 0;
  /// How far two values of the measure's view are apart, in its unit.
  [[nodiscard]] virtual double error_of(const glm::dvec3& value, const glm::dvec3& truth,
                                        const Measure& measure) const = 0;

  static inline std::unique_ptr<Measuring> (*make)() = nullptr;
};

/// What the current look needs once, before its first frame, for this many elements. The benchmark times it.
struct Preparation {
  const char* element;  ///< "triangle"
  std::size_t elements;
  std::function<void()> work;  ///< does it all again
};

/// The right answer of a lab. A lab that has one has the view `error`; a student's tree has none.
template <class Parameters>
class Answer {
 public:
  virtual ~Answer() = default;
  /// Parameters of its own, after those of the lab.
  virtual void declare(params::Set& /*set*/) {}
  /// The parameters that choose how the lab finds its picture. What is right is asked for with these at their
  /// defaults: so it cannot depend on them, and one truth serves all methods.
  [[nodiscard]] virtual std::vector<std::string_view> methods() const { return {"method"}; }
  /// What the view `error` compares.
  [[nodiscard]] virtual Measure measure(const Parameters& parameters) const = 0;
  /// The right answer in a picture of `size` pixels; empty where there is none.
  [[nodiscard]] virtual Truth truth(const Parameters& parameters, glm::ivec2 size) const = 0;
  /// For a lab that has no preparation of its own.
  [[nodiscard]] virtual std::optional<Preparation> preparation(const Parameters& /*parameters*/) const {
    return {};
  }

  /// Makes the answer of the lab with these parameters; null where the tree has none.
  static inline std::unique_ptr<Answer> (*make)() = nullptr;
};

/// Gives the lab with these parameters its answer, before main begins: `const bool known = know<…>();`
template <class Parameters, class TheAnswer>
bool know() {
  Answer<Parameters>::make = []() -> std::unique_ptr<Answer<Parameters>> {
    return std::make_unique<TheAnswer>();
  };
  return true;
}

}  // namespace texel::app
