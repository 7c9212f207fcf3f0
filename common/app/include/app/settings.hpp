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

/// Reads parameters from a TOML file: `name = value` each, as save_config writes them. Those that it does not
/// name keep their values. Throws Error with file, line and column; then nothing has changed.
void load_config(const std::filesystem::path& file, const Info& info, params::Set& parameters);

/// Writes all parameters with their help as comments.
void save_config(const std::filesystem::path& file, const Info& info, const params::Set& parameters);

/// While it lives, the parameters may have other values; then the present ones are back.
class KeptValues {
 public:
  explicit KeptValues(params::Set& parameters) : values_(parameters) {}
  ~KeptValues() { values_.set({}); }
  KeptValues(const KeptValues&) = delete;
  KeptValues& operator=(const KeptValues&) = delete;

 private:
  StartValues values_;
};

inline glm::ivec2 pixels(course::Size size) {
  return {size.width, size.height};
}

/// The view of that name. Throws Error (usage) when the lab does not have it.
View find_view(const AnyLab& lab, const std::string& name);

/// The lab's parameter that names its model file, or null.
params::Parameter* model_parameter(params::Set& parameters);

}  // namespace texel::app
