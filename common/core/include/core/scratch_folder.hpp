// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

namespace texel {

/// A new empty folder among the system's temporary files. The destructor removes it with its content.
/// Throws Error (exit 3) when it cannot be made.
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
