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

/// The labs of the course: from TEXEL_ROOT, else beside the program, else the source tree.
std::vector<course::Lab> course_labs();

/// `texel list`: the labs at a glance.
Exit list();

struct CompareOptions {
  std::filesystem::path reference, image, mask, heatmap;
  std::string unit = "auto";  ///< of two .pfm files: auto, own or degrees
  std::optional<double> max, mean, p99;
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

}  // namespace texel::tools
