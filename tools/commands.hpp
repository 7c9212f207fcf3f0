// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "course/lab_file.hpp"

/// The commands of `texel`, one file each; each returns the exit code or throws Error.
namespace texel::tools {

/// The tree that the programs belong to: TEXEL_ROOT, else beside the program, else the source tree.
std::filesystem::path course_root();
/// The build that this program belongs to.
std::filesystem::path course_build();

/// The labs of the course: from TEXEL_ROOT, else beside the program, else the source tree.
std::vector<course::Lab> course_labs();
/// The labs with these numbers; all for an empty list. Throws Error (usage) for a number without a lab.
std::vector<course::Lab> chosen_labs(const std::vector<int>& numbers);

/// The lab's program in this build.
std::filesystem::path program_of(const course::Lab& lab);
/// Whether the lab's program knows the right answers and draws the view `error`; in a student's tree it does
/// not. Throws Error (exit 3) when the program does not start.
bool knows_truth(const course::Lab& lab);

/// Makes a folder that is missing, with those above it. Throws Error (exit 3).
void make_folder(const std::filesystem::path& folder);

/// `texel list`: the labs at a glance.
Exit list();

struct CompareOptions {
  std::filesystem::path reference, image, mask, heatmap, flip_heatmap;
  std::string unit = "auto";  ///< of two .pfm files: auto, own, degrees or texels
  std::vector<int> texels;    ///< for texels: the texture's width and height, or its one size
  bool edge_tolerance = false;
  std::optional<double> pixels_per_degree;  ///< of FLIP, if not the paper's
  std::optional<double> max, mean, p99, flip;
  bool json = false;
};

/// `texel compare`: how far one picture is from another. Differs when a limit is passed, or a pixel is not
/// finite, or, where no limit is given, when the pictures are not the same.
Exit compare(const CompareOptions& options);

struct GalleryOptions {
  std::filesystem::path out = "out/gallery";
  std::vector<int> labs;         ///< numbers; none for all
  std::filesystem::path heroes;  ///< folder for the heroes, small and 3:2, or none
};

/// `texel gallery`: draws the looks of every lab that changed, and writes the page that shows them.
Exit gallery(const GalleryOptions& options);

/// `texel gallery --list`: prints docs/pictures.md, the sources' pictures with their commands.
Exit list_sources();

struct CheckOptions {
  std::vector<int> labs;  ///< numbers; none for all
  bool json = false;
  bool unless_begun = false;  ///< exit code 0 while no step of these labs is begun
  std::string context = "auto";
};

/// `texel check`: which steps of the student's tree are right. Differs when one is not.
Exit check(const CheckOptions& options);

/// `texel progress`: all labs at a glance.
Exit progress(const std::string& context);

struct SeeOptions {
  std::string step;           ///< "5.1"
  std::filesystem::path out;  ///< a .png; out/see/STEP.png if empty
  std::string context = "auto";
};

/// `texel see STEP`: writes a picture of the step's case that says most: the student's, the expected one, and
/// where they differ.
Exit see(const SeeOptions& options);

struct WatchOptions {
  int lab = 0;
  std::string context = "auto";
};

/// `texel watch`: checks after every save, until 'q' or an interrupt.
Exit watch(const WatchOptions& options);

struct HintOptions {
  std::string where;  ///< a step, a lab's number, or "" for what comes next in the course
  std::string context = "auto";
};

/// `texel hint`: one more hint each time.
Exit hint(const HintOptions& options);

/// `texel reset STEP`: restores a step's starting code, and saves the student's.
Exit reset(const std::string& step);

}  // namespace texel::tools
