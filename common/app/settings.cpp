// SPDX-License-Identifier: MIT
#include "app/settings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

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

View find_view(const AnyLab& lab, const std::string& name) {
  std::string list;
  std::vector<std::string> names;
  for (const View view : lab.views()) {
    names.emplace_back(name_of(view));
    if (names.back() == name) return view;
    list += (list.empty() ? "" : ", ") + names.back();
  }
  const std::span<const View> all = lab.info().views;
  if (std::count(all.begin(), all.end(), View::error) > 0 && name == name_of(View::error))
    throw Error::usage("the view 'error' needs the right answers; a student's tree does not contain them");
  const std::string near = nearest(name, names);
  throw Error::usage(fmt::format("this lab has no view '{}'; its views are {}", name, list),
                     near.empty() ? "" : fmt::format("did you mean '{}'?", near));
}

params::Parameter* model_parameter(params::Set& parameters) {
  params::Parameter* model = parameters.find("model");
  return model != nullptr && model->type == params::Parameter::Type::file ? model : nullptr;
}

}  // namespace texel::app
