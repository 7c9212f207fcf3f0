// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "course/lab_file.hpp"

/// What the course's makers do with its own tree.
namespace texel::grade {

struct CourseTree {
  std::filesystem::path course, build, cache;  ///< as for GradeOptions
  std::vector<course::Lab> labs;
};

/// Draws the expected pictures of the course's own tree anew, by its solutions, and what its catalogue of
/// mutants looks like. `say` gets a line for each lab. Throws Error (exit 3) when something does not draw.
void write_expected(const CourseTree& options, const std::function<void(const std::string&)>& say);

/// Holds the course to what it promises of its starter, lab by lab: as it is it fails every step; with the
/// first k steps solved it passes those k and no other; with all it passes all. Hidden cases count too. What
/// is not so is returned, a line each. `say` gets progress. Throws Error (exit 3) when the starter does not
/// build (a warning is an error there), or something does not draw.
std::vector<std::string> verify_starter(const CourseTree& options,
                                        const std::function<void(const std::string&)>& say);

}  // namespace texel::grade
