// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "course/step.hpp"

namespace texel::tools {

/// Which hints were shown, in a file.
class Hints {
 public:
  explicit Hints(std::filesystem::path file) : file_(std::move(file)) {}

  /// The step's hints that were shown and one more, as text. Throws Error (exit 3) when the file cannot be
  /// written.
  std::string next(const course::Step& step);

 private:
  std::filesystem::path file_;
};

/// The tree's own, in its build.
std::filesystem::path hints_file();

}  // namespace texel::tools
