// SPDX-License-Identifier: MIT
#include "check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/files.hpp"
#include "image/difference.hpp"
#include "image/load.hpp"

namespace texel::assets {

namespace fs = std::filesystem;

namespace {

bool same_picture(const fs::path& a, const fs::path& b) {
  const image::Info of_a = image::info(a), of_b = image::info(b);
  if (of_a.width != of_b.width || of_a.height != of_b.height || of_a.channels != of_b.channels ||
      of_a.is_16_bit != of_b.is_16_bit) {
    return false;
  }
  if (of_a.is_16_bit) return image::load16(a) == image::load16(b);
  return image::compare(image::load8(a), image::load8(b)).max <= 1;
}

/// Empty when the files agree, else how they do not.
std::string disagreement(const fs::path& fresh, const fs::path& committed) {
  if (!fs::exists(committed)) return "missing";
  if (read_file(fresh) == read_file(committed)) return "";
  return fresh.extension() == ".png" && same_picture(fresh, committed) ? "" : "differs";
}

}  // namespace

bool same_files(const fs::path& fresh, const fs::path& committed) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fresh)) {
    if (entry.is_regular_file()) files.push_back(fs::relative(entry.path(), fresh));
  }
  std::sort(files.begin(), files.end());
  std::size_t wrong = 0;
  for (const fs::path& file : files) {
    const std::string how = disagreement(fresh / file, committed / file);
    if (how.empty()) continue;
    ++wrong;
    fmt::print("{}: {}\n", how, (committed / file).string());
  }
  fmt::print("{} of {} files agree\n", files.size() - wrong, files.size());
  return wrong == 0;
}

}  // namespace texel::assets
