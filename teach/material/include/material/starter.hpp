// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

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

}  // namespace texel::material
