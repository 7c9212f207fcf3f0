// SPDX-License-Identifier: MIT
#include "app/settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "course/reader.hpp"

namespace texel::app {

KeptValues::KeptValues(params::Set& parameters) : parameters_(parameters) {
  for (const params::Parameter& p : parameters) values_.push_back(p.text());
}

void KeptValues::set(const Settings& settings) const {
  auto value = values_.begin();
  for (params::Parameter& p : parameters_) p.set(*value++);
  for (const auto& [parameter, text] : settings) parameters_.at(parameter).set(text);
}

void check_settings(params::Set& parameters, const Settings& settings) {
  KeptValues(parameters).set(settings);
}

void apply_settings(params::Set& parameters, const Settings& settings) {
  check_settings(parameters, settings);
  for (const auto& [parameter, value] : settings) parameters.at(parameter).set(value);
}

void load_config(const std::filesystem::path& file, const Info& info, params::Set& parameters) {
  const toml::table table = course::read_toml(file, "write lines 'name = value', as --save-config does");
  const course::Reader reader(table, file.string());
  Settings settings;
  for (const auto& [key, node] : table) {
    const std::string value = reader.setting(node);
    if (key.str() != "lab")
      settings.push_back({std::string(key.str()), value});
    else if (value != info.folder())
      throw Error::usage(fmt::format("{}: the file is for the lab '{}'", file.string(), value));
  }
  try {
    apply_settings(parameters, settings);
  } catch (const Error& error) {
    throw Error::usage(fmt::format("{}: {}", file.string(), error.what()));
  }
}

void save_config(const std::filesystem::path& file, const Info& info, const params::Set& parameters) {
  std::string text = fmt::format("lab = \"{}\"\n", info.folder());
  for (const params::Parameter& p : parameters) {
    const std::string value = p.type == params::Parameter::Type::toggle ? (p.value() != 0 ? "true" : "false")
                              : p.is_ranged()                           ? p.text()
                                                                        : to_text(Json(p.text()));
    text +=
        fmt::format("\n# {}{}{}\n{} = {}\n", p.help, p.unit.empty() ? "" : ", in ", p.unit, p.name, value);
  }
  write_file(file, text);
}

View find_view(const AnyLab& lab, const std::string& name) {
  std::vector<std::string> names;
  for (const View view : lab.views()) {
    names.emplace_back(name_of(view));
    if (names.back() == name) return view;
  }
  if (name == name_of(View::error))
    throw Error::usage("the view 'error' needs the right answers; a student's tree does not contain them");
  throw Error::usage(fmt::format("this lab has no view '{}'; its views are {}", name, fmt::join(names, ", ")),
                     did_you_mean(name, names));
}

params::Parameter* model_parameter(params::Set& parameters) {
  params::Parameter* model = parameters.find("model");
  return model != nullptr && model->type == params::Parameter::Type::file ? model : nullptr;
}

}  // namespace texel::app
