// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "app/measure.hpp"
#include "params/set.hpp"

namespace texel::app {

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
