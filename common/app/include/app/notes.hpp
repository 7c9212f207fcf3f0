// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace texel::app {

/// What a lab has to say of its input.
struct Notes {
  std::vector<std::string> warnings;  ///< what is wrong with it: repairs, missing files
  std::vector<std::string> facts;     ///< what was generated, and figures worth knowing
};

}  // namespace texel::app
