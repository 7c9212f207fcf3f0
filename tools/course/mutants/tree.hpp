// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

#include "course/mutant_file.hpp"

namespace texel::tools {

/// A copy of a source tree in which mutants are made. The original stays as it is.
class Tree {
 public:
  /// `root`: the tree; `copy`: the folder for its copy. Throws Error (exit 2) when the copy would hold the
  /// tree.
  Tree(std::filesystem::path root, std::filesystem::path copy);

  [[nodiscard]] const std::filesystem::path& folder() const { return copy_; }

  /// Makes the copy as the tree is now: all files but those of .git, build and out. Files that are the same
  /// are left alone, so that little is built again. Throws Error (exit 3) when a file cannot be copied.
  void update() const;

  /// A text that stands for all paths and contents of the original. Throws Error (exit 3).
  [[nodiscard]] std::string state() const;

 private:
  std::filesystem::path root_, copy_;
};

/// A mutant in the copy, from construction to destruction.
class AppliedMutant {
 public:
  /// Throws Error (exit 3) when the mutant does not apply.
  AppliedMutant(const Tree& tree, const course::Mutant& mutant);
  ~AppliedMutant();
  AppliedMutant(const AppliedMutant&) = delete;
  AppliedMutant& operator=(const AppliedMutant&) = delete;

 private:
  std::filesystem::path file_;
  std::string original_;
};

}  // namespace texel::tools
