// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

namespace texel {

/// A new empty folder in the system's place for temporary files, removed at the end with all that is in it.
/// Throws Error (exit 3) when there is none to be had.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace texel
