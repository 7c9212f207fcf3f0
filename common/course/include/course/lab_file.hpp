// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "course/case.hpp"

/// What `labs/NN_name/lab.toml` says of a lab: its title and lesson, the looks that are worth seeing, and
/// what a student writes, with the pictures that judge it. docs/adding_a_lab.md shows one. The tables
/// [[bench]] and [[claim]] and the list driver_methods are the benchmark's: nobody reads them here.
namespace texel::course {

/// A picture that is worth seeing. Its name has lower-case letters, digits, '_' and '-'.
struct Look : Case {
  std::string caption;  ///< one line of plain text
  std::string source;   ///< which picture of the sources it is, or ""
  bool hero = false;    ///< shown at the top of the gallery and in the README

  // Of the opening:
  std::optional<Setting> right = {};    ///< what differs right of a line
  std::vector<std::string> sides = {};  ///< the names of what is left and right of it
};

/// What a student writes.
struct Step {
  std::string id, title;
  double points = 1;
  std::vector<std::string> needs;  ///< earlier steps of this lab, directly and through others, in its order
  std::vector<std::string> hints;
  Case see = {};                            ///< the look in which one sees it: its settings and view
  std::vector<std::string> seen_with = {};  ///< later steps of this lab, without which one does not see it
};

/// A parameter whose value is drawn from the secret seed.
struct Hidden {
  std::string parameter;
  double least = 0, most = 0;       ///< between these, or
  std::vector<std::string> values;  ///< one of these
};

/// A model that nobody has seen, made from the seed: the value `unseen:polygons` of a parameter.
inline constexpr const char* kUnseen = "unseen:";

/// A picture (or vertex stream) of the student's beside the solution's.
struct GradedCase : Case {
  std::string why;                      ///< where the limit comes from
  std::vector<Hidden> hidden_settings;  ///< what is drawn for it
};

struct Lab {
  int number = 0;
  std::string folder;               ///< "05_normal_map"
  std::vector<std::string> copies;  ///< folders beside it whose lab.toml is this one's: they are no labs
  std::string title, lesson;
  std::string choice;  ///< which method is the default, and why; or ""
  std::vector<Look> looks;
  std::vector<Look> openings;  ///< none, or the look with which window and page open; the gallery has it not
  std::vector<Step> steps;
  std::vector<GradedCase> cases;  ///< at least one for each step

  [[nodiscard]] std::string program() const { return "lab" + folder; }
};

/// Reads a lab.toml. Throws Error (exit 3) with file and line for broken TOML, an unknown key, a wrong type,
/// a missing or empty text, a name that is taken or no file name, a step or case that does not fit the
/// others, and a `lab` that is not the name of the file's folder.
Lab read_lab(const std::filesystem::path& file);

/// The lab of a step that is written as "5.1", two numbers with a point between them; 0 for a text that is
/// none.
int lab_of_step(const std::string& step);

/// The lab's folder of which another folder below `labs` is a copy, as its lab.toml says; "" for one that is
/// none. Throws Error (exit 3) when the file cannot be read.
std::string copied_from(const std::filesystem::path& folder);

/// Whether a file with steps has such a name as only file managers, editors, cloud drives and git give, to
/// what they leave beside the real one: "lab (1).cpp", "lab.cpp~", "lab.cpp.orig", "lab_BACKUP_12.cpp".
bool is_left_over(const std::filesystem::path& file);

/// Every `NN_name/lab.toml` below `folder`, by number. A copy of a lab's folder is said in the lab's
/// `copies`, and not read; nor are other files and folders. Throws Error (exit 3) when there is none, or as
/// read_lab.
std::vector<Lab> read_labs(const std::filesystem::path& folder);

/// A setting as the programs' command line takes it, after a space: " --turn 50".
std::string flag(const Setting& setting);

/// The command, typed in the project's root, that draws the look: "./run lab 5 --model torus --snapshot
/// bricks.png".
std::string command(const Lab& lab, const Look& look);

}  // namespace texel::course
