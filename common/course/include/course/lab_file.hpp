// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "course/case.hpp"
#include "course/step.hpp"

/// What `labs/NN_name/lab.toml` says of a lab: its title and lesson, the looks that are worth seeing, and the
/// cases on which its methods are measured.
///
///     lab = "05_normal_map"
///     title = "Normal map"
///     lesson = "One line, as in the program's --help"
///     [[look]]
///     name = "bricks"                                     # the picture's file name, unique in the lab
///     caption = "Bricks by MikkTSpace tangents"
///     set = { model = "torus", method = "mikktspace" }    # parameters that differ from the default
///     view = "color"                                      # optional
///     size = "512x512"                                    # optional
///     source = "Report, section 3.2, 'Cube before …'"     # optional: the sources' picture that this is
///     hero = true                                         # optional: at the top of the gallery
///     [[bench]]
///     case = "jittered torus"                             # unique in the lab
///     teaches = "A sentence or two, below the table"
///     hard = true                                         # optional
///     set = { model = "torus", jitter = 0.5 }             # optional
///     vary = { method = [], segments = [16, 32] }         # every combination; []: all values of a choice
///     size = "256x256"                                    # optional
///
///     [[claim]]
///     source = "Slides, 'Normal Mapping'"                 # who says it
///     says = "If the triangles are small, …"              # and what
///     found = "True: …"                                   # what measuring it gave
///     see = "./run bench 5"                               # a command that shows it
///
/// and at the top, after the lesson, `choice`: which method the lab takes by default, and why. The steps and
/// the cases by which they are graded are in course/step.hpp.
namespace texel::course {

/// A picture that is worth seeing. Its name has lower-case letters, digits, '_' and '-'.
struct Look : Case {
  std::string caption;  ///< one line of plain text
  std::string source;   ///< which picture of the sources it is, or ""
  bool hero = false;    ///< shown at the top of the gallery and in the README
};

/// A parameter and the values that it takes one after the other; none for all of a choice.
struct Variation {
  std::string parameter;
  std::vector<std::string> values;

  bool operator==(const Variation&) const = default;
};

/// A scene on which methods are measured against the truth and against the clock.
struct BenchCase : Case {
  std::string teaches;                ///< plain text
  bool hard = false;                  ///< one that breaks the naive method
  std::vector<Variation> variations;  ///< at least one
};

/// What one of the sources says, and what measuring it gave.
struct Claim {
  std::string source, says, found, see;
};

struct Lab {
  int number = 0;
  std::string folder;               ///< "05_normal_map"
  std::vector<std::string> copies;  ///< folders beside it whose lab.toml is this one's: they are no labs
  std::string title, lesson;
  std::string choice;                       ///< which method is the default, and why; or ""
  std::vector<std::string> driver_methods;  ///< methods whose result OpenGL leaves to the driver
  std::vector<Look> looks;
  std::vector<BenchCase> bench;
  std::vector<Claim> claims;
  std::vector<Step> steps;
  std::vector<GradedCase> cases;  ///< at least one for each step

  [[nodiscard]] std::string program() const { return "lab" + folder; }
};

/// Reads a lab.toml. Throws Error (exit 3) with file and line for broken TOML, an unknown key, a wrong type,
/// a missing or empty text, a name that is taken or no file name, a step or case that does not fit the
/// others, and a `lab` that is not the name of the file's folder. It does not know whether steps of earlier
/// labs exist that this lab needs.
Lab read_lab(const std::filesystem::path& file);

/// The lab's folder of which another folder below `labs` is a copy, as its lab.toml says; "" for one that is
/// none. Throws Error (exit 3) when the file cannot be read.
std::string copied_from(const std::filesystem::path& folder);

/// Whether a file with steps has such a name as only file managers, editors, cloud drives and git give, to
/// what they leave beside the real one: "lab (1).cpp", "lab.cpp~", "lab.cpp.orig", "lab_BACKUP_12.cpp".
bool is_left_over(const std::filesystem::path& file);

/// Every `NN_name/lab.toml` below `folder`, by number. A copy of a lab's folder is said in the lab's
/// `copies`, and not read; nor are other files and folders. Throws Error (exit 3) when there is none, when a
/// step needs one that no lab has, or as read_lab.
std::vector<Lab> read_labs(const std::filesystem::path& folder);

/// A setting as the programs' command line takes it, after a space: " --turn 50".
std::string flag(const Setting& setting);

/// The command, typed in the project's root, that draws the look: "./run lab 5 --model torus --snapshot
/// bricks.png".
std::string command(const Lab& lab, const Look& look);

}  // namespace texel::course
