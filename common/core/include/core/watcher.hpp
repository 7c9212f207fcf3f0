// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <vector>

namespace texel {

/// Notices edited files by their time and size, and folders in which a file came or went. Editors that write
/// beside and rename are noticed too.
class Watcher {
 public:
  /// Which of `files` are not as they were at the last call (a file seen for the first time is not changed).
  std::vector<std::filesystem::path> changed(const std::vector<std::filesystem::path>& files);

 private:
  struct Stamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const Stamp&) const = default;
  };
  std::map<std::filesystem::path, Stamp> stamps_;
};

}  // namespace texel
