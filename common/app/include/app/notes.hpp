// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace texel::app {

/// A lab's notes on its input.
struct Notes {
  std::vector<std::string> warnings;  ///< what is wrong with it: repairs, missing files
  std::vector<std::string> facts;     ///< what was generated, and figures worth knowing
};

}  // namespace texel::app
