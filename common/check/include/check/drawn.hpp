// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>
#include <vector>

namespace texel::check {

/// The reasons why files are missing, by the file's name, and remarks on the whole.
struct Drawn {
  std::map<std::string, std::string> faults;
  /// Of those that the lab's program refused to draw: the file and line that it blames, as "cube.obj:9", or
  /// "". Not of those at which it died or never ended, as it does by many mistakes.
  std::map<std::string, std::string> refused;
  std::vector<std::string> notes;
  std::string renderer;  ///< the driver that drew, as the program says it, or ""
};

}  // namespace texel::check
