// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"

/// What a student gets: the tree of the course without tests, solutions and right answers.
namespace texel::material {

/// A file of the starter.
struct StarterFile {
  std::string path;                 ///< in the student's tree
  std::filesystem::path source;     ///< in the course's
  std::optional<std::string> text;  ///< what it holds, unless it is the source byte by byte
};

/// The starter's files, by their paths. Steps with `solved(step)` are solved. Throws Error (exit
/// 3) when `root` is not the course's source tree or cannot be read, and as with_steps.
std::vector<StarterFile> starter_files(
    const std::filesystem::path& root,
    const std::function<bool(const std::string&)>& solved = [](const std::string&) { return false; });

/// Writes them into a new folder. Throws Error (exit 2) when `to` is not empty, Error (exit 3)
/// when writing fails.
void write_files(const std::vector<StarterFile>& files, const std::filesystem::path& to);

/// The text of a student's file with the solution standing in for all steps but one: what stands between
/// their markers is taken from `solution`, and all other lines stay. Where markers are damaged, nobody knows
/// where those steps stand: there the one step is put into the solution. Throws Error (exit 3) when the
/// step's own markers are damaged.
std::string with_step_alone(const std::string& text, const std::string& file, const std::string& step,
                            const std::string& solution);

/// Where a new starter has each step of the course's tree. Throws Error (exit 3) as course::step_places.
std::map<std::string, Place> first_places(const std::filesystem::path& course);

}  // namespace texel::material
