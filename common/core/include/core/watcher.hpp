// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <vector>

namespace texel {

/// Notices edited files by their time and size, and folders in which a file appeared or vanished. Also
/// works with editors that write another file and rename it.
class Watcher {
 public:
  /// Which of `files` changed since the last call. A file seen for the first time is not changed.
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
