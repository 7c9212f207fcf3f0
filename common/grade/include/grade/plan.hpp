// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "course/lab_file.hpp"

/// Which pictures are drawn to judge a lab: its cases with every parameter settled.
namespace texel::grade {

/// A case with the values that are used for it.
struct Shot {
  course::GradedCase graded;
  std::vector<course::Setting> settings;  ///< of the case, and those that were drawn for it
  bool hidden = false;                    ///< some were

  [[nodiscard]] bool is_mesh() const { return graded.view == "mesh"; }
  /// The file that the lab's program writes: "name.png", ".pfm" for data views, ".ply" for a vertex stream.
  [[nodiscard]] std::string file() const;
};

/// A text that OBJ files are made for, which nobody has seen: the value `unseen:polygons` of a parameter.
inline constexpr const char* kUnseen = "unseen:";

struct LabPlan {
  course::Lab lab;
  std::vector<Shot> shots;  ///< in the file's order

  /// The list for the program's option --batch. `only` names cases; none for all.
  [[nodiscard]] std::string batch(const std::vector<std::string>& only = {}) const;
  /// The views `mask` of the same pictures, for the shots that have one.
  [[nodiscard]] std::string mask_batch() const;
};

/// The cases of the labs. Hidden values are drawn from the seed, the lab, the case and the parameter, so that
/// they stay the same for all submissions and when other cases come or go. Models that nobody has seen are
/// written into `models`. With an empty seed hidden cases are left out: that is what students can check.
/// Throws Error (exit 3) when the folder cannot be written.
std::vector<LabPlan> plan(const std::vector<course::Lab>& labs, const std::string& seed,
                          const std::filesystem::path& models);

/// The labs with those, before them, whose steps they need, in the order of their numbers.
std::vector<course::Lab> with_needed(const std::vector<course::Lab>& chosen,
                                     const std::vector<course::Lab>& all);

/// The command that draws the shot, typed in the project's root: "./run lab 5 --model torus --view normal
/// --size 128x128 --snapshot decode.pfm".
std::string command(const LabPlan& plan, const Shot& shot);

}  // namespace texel::grade
