// SPDX-License-Identifier: MIT
#include "settings.hpp"

namespace texel::app {

void check_settings(params::Set& parameters, const Settings& settings) {
  for (const auto& [parameter, value] : settings) {
    params::Parameter& p = parameters.at(parameter);
    const std::string before = p.text();
    p.set(value);
    p.set(before);
  }
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
