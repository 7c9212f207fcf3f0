// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "course/case.hpp"

/// What `labs/NN_name/lab.toml` says of a lab: its title and lesson, the looks that are worth seeing, and
/// what a student writes, with the pictures that judge it. The tables [[bench]] and [[claim]], the list
/// driver_methods and the text choice are the benchmark's, and seen_with of a step is for its handout's
/// picture: nobody reads them here.
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
  std::map<std::string, std::size_t> hint_of = {};  ///< from 1, of the cases whose names begin so
  Case see = {};                                    ///< the look in which one sees it: its settings and view
};

/// A model that nobody has seen, made from the seed: the value `unseen:polygons` of a parameter.
inline constexpr std::string_view kUnseen = "unseen:";

struct Lab {
  int number = 0;
  std::string folder;               ///< "05_normal_map"
  std::vector<std::string> copies;  ///< folders beside it whose lab.toml is this one's: they are no labs
  std::string title, lesson;
  std::vector<Look> looks;
  std::vector<Look> openings;  ///< none, or the look with which window and page open; the gallery has it not
  std::vector<Step> steps;
  std::vector<Case> cases;  ///< in its file at least one for each step

  [[nodiscard]] std::string program() const { return "lab" + folder; }
};

/// Reads a lab.toml. Throws Error (exit 3) with file and line for broken TOML, an unknown key, a wrong type,
/// a missing or empty text, a name that is taken or no file name, a step or case that does not fit the
/// others, and a `lab` that is not the name of the file's folder.
Lab read_lab(const std::filesystem::path& file);

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

/// The lab with the cases that students can check: all but the hidden ones.
Lab with_public_cases(Lab lab);

/// The command, typed in the project's root, that draws a look or a graded case: "./run lab 5 --model torus
/// --view normal --size 128x128 --snapshot decode.pfm".
std::string command(const Lab& lab, const Case& of);

}  // namespace texel::course
