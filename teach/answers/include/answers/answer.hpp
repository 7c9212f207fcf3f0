// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/answer.hpp"
#include "app/settings.hpp"

namespace texel::answers {

/// What the view should show at a place of the picture, in pixels from its lower left corner, from the
/// analytic answer in double precision: a unit vector for degrees, (s, t) for texels, 8-bit values (not
/// rounded) for colours, a level in x. Nothing beside the object. May be called by several threads at a time.
/// An empty function if there is no analytic answer (an OBJ file).
using Truth = std::function<std::optional<glm::dvec3>(glm::dvec2 window)>;

/// What compares pictures with a truth. It keeps the truth of the last look.
class Measuring : public app::Answer {
 public:
  double work(glm::ivec2 size, double milliseconds) final;
  [[nodiscard]] app::Measured measured(app::Canvas& canvas, glm::ivec2 size) final;
  [[nodiscard]] std::optional<app::Comparison> compare_at(app::Canvas& canvas, glm::ivec2 size,
                                                          glm::ivec2 pixel) final;
  [[nodiscard]] std::string report(app::AnyLab& lab, const app::ErrorFigures& figures) const final;

 protected:
  /// The truth for the present parameters in a picture of `size` pixels, and those that it depends on: with
  /// equal keys, pictures of one size have the same truth.
  struct Keyed {
    Truth truth;
    std::string key;
  };
  [[nodiscard]] virtual Keyed truth(glm::ivec2 size) const = 0;

 private:
  std::string key_;  ///< of which look truth_ is
  image::ImageF truth_;
  int rows_ = 0;  ///< so many of its rows are there
  double truth_error_ = 0;
};

/// The right answer of the lab with these parameters.
template <class Parameters>
class Answer : public Measuring {
 public:
  /// Parameters of its own, after those of the lab.
  virtual void declare(params::Set& /*set*/) {}
  /// The parameters that choose how the lab finds its picture. What is right is asked for with these at their
  /// defaults: so it cannot depend on them, and one truth serves all methods.
  [[nodiscard]] virtual std::vector<std::string_view> methods() const { return {"method"}; }
  [[nodiscard]] virtual app::Measure measure(const Parameters& parameters) const = 0;
  /// The right answer in a picture of `size` pixels; empty where there is none.
  [[nodiscard]] virtual Truth truth(const Parameters& parameters, glm::ivec2 size) const = 0;
  [[nodiscard]] virtual std::optional<app::Preparation> preparation(const Parameters& /*parameters*/,
                                                                    const app::Assets& /*assets*/) const {
    return {};
  }

  /// Of the lab that has these.
  void attach(const Parameters& parameters, params::Set& set) {
    parameters_ = &parameters, set_ = &set;
    declare(set);
  }
  [[nodiscard]] app::Measure measure() const final { return measure(*parameters_); }
  [[nodiscard]] std::optional<app::Preparation> preparation(const app::Assets& assets) const final {
    return preparation(*parameters_, assets);
  }

 protected:
  [[nodiscard]] Measuring::Keyed truth(glm::ivec2 size) const final {
    const app::KeptValues before(*set_);
    for (const std::string_view name : methods()) set_->at(name).reset();
    return {truth(*parameters_, size), set_->key()};
  }

 private:
  const Parameters* parameters_ = nullptr;
  params::Set* set_ = nullptr;
};

/// One with a parameter `truth`, which says what the view `error` compares.
template <class Parameters, class Choice>
class ChosenAnswer : public Answer<Parameters> {
 public:
  void declare(params::Set& set) final {
    set.section("Error");
    set.add(chosen_, truths_);
  }

 protected:
  explicit ChosenAnswer(params::Choice<Choice> truths) : truths_(truths) {}
  Choice chosen_{};

 private:
  params::Choice<Choice> truths_;
};

/// Gives the lab with these parameters its answer, before main begins: `const bool known = know<…>();`
template <class Parameters, class TheAnswer>
bool know() {
  app::make_answer<Parameters> = [](Parameters& parameters,
                                    params::Set& set) -> std::unique_ptr<app::Answer> {
    auto answer = std::make_unique<TheAnswer>();
    answer->attach(parameters, set);
    return answer;
  };
  return true;
}

}  // namespace texel::answers
