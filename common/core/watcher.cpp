// SPDX-License-Identifier: MIT
#include "core/watcher.hpp"

namespace texel {

std::vector<std::filesystem::path> Watcher::changed(const std::vector<std::filesystem::path>& files) {
  std::vector<std::filesystem::path> result;
  for (const std::filesystem::path& file : files) {
    std::error_code error;
    Stamp stamp;
    stamp.time = std::filesystem::last_write_time(file, error);
    if (!error && !std::filesystem::is_directory(file)) stamp.size = std::filesystem::file_size(file, error);
    if (error) stamp = {};  // missing for the moment between an editor's delete and rename
    const auto [known, is_new] = stamps_.try_emplace(file, stamp);
    if (is_new || known->second == stamp) continue;
    known->second = stamp;
    result.push_back(file);
  }
  return result;
}

}  // namespace texel
