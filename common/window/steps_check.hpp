// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "app/legend.hpp"
#include "course/lab_file.hpp"
#include "course/step_text.hpp"
#include "image/compared.hpp"
#include "judge/results.hpp"
#include "window/gui.hpp"

namespace texel::window {

/// A case's pictures: the student's, the expected one, and how they differ; beside them the step's text.
struct CasePictures {
  std::string step, title;  ///< of the step
  judge::CaseResult result;
  course::StepText text;
  std::string fault;              ///< why there is nothing to be seen, or ""
  bool shows_difference = false;  ///< in place of yours and the expected one
  std::size_t chosen = 0;         ///< answer to the step's question, from 1
  float position = 0.5F;          ///< of the split line, 0 to 1; the expected picture is right of it
  image::Compared compared;
  gl::Texture own, expected, difference;  ///< its pictures, bottom row first; the last as a heat map
  app::Legend legend;                     ///< of the difference
  gl::Texture legend_picture;

  /// Height by width of the pictures, which are there without a fault.
  [[nodiscard]] float aspect() const {
    return static_cast<float>(compared.own.height) / static_cast<float>(compared.own.width);
  }
};

/// Has the steps of a lab checked, one check after the other, in the background. The figures are those of
/// `texel check`, which runs beside the window and draws as the grader does, whatever graphics card shows the
/// window.
class StepsCheck {
 public:
  /// What a check found.
  struct Found {
    std::vector<judge::StepResult> steps;
    std::vector<judge::StepResult> course;  ///< of all labs, once they are known
    std::string fault;                      ///< why there are no steps, or ""
    std::string compile_error;              ///< what the compiler said of what was saved last, or ""
  };

  /// `root` is the tree whose labs and shaders are checked, by the `texel` beside this program.
  StepsCheck(const std::string& lab_folder, std::filesystem::path root);

  /// Asks for a check of what is saved now, and to build the lab's program first. During a check: for another
  /// one after it.
  void request(bool build = false);
  /// Takes over what the last check found; whether there is something new.
  bool poll();
  [[nodiscard]] const Found& found() const { return found_; }

  /// "building", "checking your steps" or "".
  [[nodiscard]] std::string progress() const;
  /// The C++ files that a student edits; none where this program was not built from this tree.
  [[nodiscard]] const std::vector<std::filesystem::path>& program_texts() const { return program_texts_; }
  /// The look in which one sees a step of this lab best, as its handout shows it.
  [[nodiscard]] const course::Case& look_of(const std::string& step) const;
  /// A case's pictures, and its step's text. Files that are missing or broken are said so in `fault`.
  [[nodiscard]] CasePictures load_case(const judge::StepResult& step, const judge::CaseResult& one) const;

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
  Found found_;
  std::vector<std::filesystem::path> program_texts_;
};

}  // namespace texel::window
