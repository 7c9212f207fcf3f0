// SPDX-License-Identifier: MIT
#include "settings.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace texel::app {

using Json = nlohmann::ordered_json;

std::string as_text(const Json& value) {
  if (value.is_boolean()) return value.get<bool>() ? "on" : "off";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return fmt::format("{}", value.get<long long>());
  if (value.is_number()) return fmt::format("{}", static_cast<float>(value.get<double>()));
  throw Error::usage(
      fmt::format("a parameter's value must be a string, number or boolean, not {}", value.dump()));
}

Settings read_settings(const Json& json, const char* key, params::Set& parameters) {
  Settings settings;
  if (!json.contains(key)) return settings;
  if (!json.at(key).is_object())
    throw Error::usage(fmt::format("'{}' must be an object {{parameter: value}}", key));
  for (const auto& [parameter, value] : json.at(key).items()) {
    settings.emplace_back(parameter, as_text(value));
    check_setting(parameters, parameter, settings.back().second);
  }
  return settings;
}

void check_setting(params::Set& parameters, const std::string& parameter, const std::string& value) {
  params::Parameter& p = parameters.at(parameter);
  const std::string before = p.text();
  p.set(value);
  p.set(before);
}

StartValues::StartValues(params::Set& parameters) : parameters_(parameters) {
  for (const params::Parameter& p : parameters) values_.push_back(p.text());
}

void StartValues::set(const Settings& settings) const {
  auto value = values_.begin();
  for (params::Parameter& p : parameters_) p.set(*value++);
  for (const auto& [parameter, text] : settings) parameters_.at(parameter).set(text);
}

}  // namespace texel::app
