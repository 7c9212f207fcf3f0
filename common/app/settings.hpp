// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "course/setting.hpp"
#include "params/set.hpp"

namespace texel::app {

using Settings = std::vector<course::Setting>;

/// Throws Error (usage) for an unknown parameter and for a value that is not one of its own; all stay as they
/// are.
void check_settings(params::Set& parameters, const Settings& settings);

/// The defaults of a run: all values as they were when it was made.
class StartValues {
 public:
  explicit StartValues(params::Set& parameters);
  /// Those values, without the settings.
  void set(const Settings& settings) const;

 private:
  params::Set& parameters_;
  std::vector<std::string> values_;
};

}  // namespace texel::app
