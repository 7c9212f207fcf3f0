// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/lab.hpp"
#include "course/case.hpp"
#include "params/set.hpp"

namespace texel::app {

using Settings = std::vector<course::Setting>;

/// All values as they were when it was made; at the end of its scope the parameters have them again.
class KeptValues {
 public:
  explicit KeptValues(params::Set& parameters);
  ~KeptValues() { set({}); }
  KeptValues& operator=(KeptValues&&) = delete;
  /// Those values, but for the settings.
  void set(const Settings& settings) const;

 private:
  params::Set& parameters_;
  std::vector<std::string> values_;
};

/// Throws Error (usage) for an unknown parameter and for a value that is not one of its own; all stay as they
/// are.
void check_settings(params::Set& parameters, const Settings& settings);
/// Sets them, or throws as check_settings.
void apply_settings(params::Set& parameters, const Settings& settings);

/// Reads parameters from a TOML file: `name = value` each, as save_config writes them. Those that it does not
/// name keep their values. Throws Error with file, line and column; then nothing has changed.
void load_config(const std::filesystem::path& file, const Info& info, params::Set& parameters);

/// Writes all parameters with their help as comments.
void save_config(const std::filesystem::path& file, const Info& info, const params::Set& parameters);

inline glm::ivec2 pixels(course::Size size) {
  return {size.width, size.height};
}

/// The view of that name. Throws Error (usage) when the lab does not have it.
View find_view(const AnyLab& lab, const std::string& name);

/// The lab's parameter that names its model file, or null.
params::Parameter* model_parameter(params::Set& parameters);

}  // namespace texel::app
