// SPDX-License-Identifier: MIT
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "params/set.hpp"

/// Parameters' values in JSON files.
namespace texel::app {

/// A parameter and its value as the command line takes it.
using Settings = std::vector<std::pair<std::string, std::string>>;

/// A string, number or boolean as the command line takes it. Throws Error (usage) for anything else.
std::string as_text(const nlohmann::ordered_json& value);

/// The object at `key`, or nothing when there is none. Throws Error (usage) for an unknown parameter and for
/// a value that is not one of its own.
Settings read_settings(const nlohmann::ordered_json& json, const char* key, params::Set& parameters);

/// Sets a parameter and puts it back: throws Error (usage) when it does not take the value.
void check_setting(params::Set& parameters, const std::string& parameter, const std::string& value);

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
