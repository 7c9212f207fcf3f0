// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace texel::course {

/// A parameter and its value as the command line takes it: {"normal_map", "on"}.
struct Setting {
  std::string parameter, value;

  bool operator==(const Setting&) const = default;
};

}  // namespace texel::course
