// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "app/lab.hpp"
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

inline glm::ivec2 pixels(course::Size size) {
  return {size.width, size.height};
}

/// The view of that name. Throws Error (usage) when the lab does not have it.
View find_view(const AnyLab& lab, const std::string& name);

/// The lab's parameter that names its model file, or null.
params::Parameter* model_parameter(params::Set& parameters);

}  // namespace texel::app
