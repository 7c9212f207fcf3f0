// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

namespace texel::assets {

/// A new empty folder in the system's place for temporary files, removed at the end with all that is in it.
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

/// Whether each file under `fresh` is in `committed` too, with the same bytes; pictures may be packed by
/// another version of zlib, and differ by one step where another library's sine rounds the other way. Prints
/// what differs.
bool same_files(const std::filesystem::path& fresh, const std::filesystem::path& committed);

}  // namespace texel::assets
