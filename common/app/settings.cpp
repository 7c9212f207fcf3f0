// SPDX-License-Identifier: MIT
#include "app/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include <toml++/toml.h>

#include "core/error.hpp"
#include "core/files.hpp"

namespace texel::app {
namespace {

/// The value as the command line would write it.
std::string as_text(const toml::node& node) {
  if (const auto value = node.value_exact<bool>()) return *value ? "on" : "off";
  if (const auto value = node.value_exact<std::int64_t>()) return fmt::format("{}", *value);
  if (const auto value = node.value_exact<double>()) return fmt::format("{}", static_cast<float>(*value));
  return node.value_or(std::string());
}

}  // namespace

void check_settings(params::Set& parameters, const Settings& settings) {
  const KeptValues before(parameters);
  for (const auto& [parameter, value] : settings) parameters.at(parameter).set(value);
}

StartValues::StartValues(params::Set& parameters) : parameters_(parameters) {
  for (const params::Parameter& p : parameters) values_.push_back(p.text());
}

void StartValues::set(const Settings& settings) const {
  auto value = values_.begin();
  for (params::Parameter& p : parameters_) p.set(*value++);
  for (const auto& [parameter, text] : settings) parameters_.at(parameter).set(text);
}

void load_config(const std::filesystem::path& file, const Info& info, params::Set& parameters) {
  toml::table table;
  try {
    table = toml::parse(read_file(file), file.string());
  } catch (const toml::parse_error& error) {
    throw Error::failed(std::string(error.description()),
                        {file.string(), static_cast<int>(error.source().begin.line),
                         static_cast<int>(error.source().begin.column)},
                        "write lines 'name = value', as --save-config does");
  }
  const StartValues before(parameters);
  try {
    for (const auto& [key, node] : table) {
      const std::string value = as_text(node);
      if (key.str() != "lab")
        parameters.at(key.str()).set(value);
      else if (value != info.folder())
        throw Error::usage(fmt::format("the file is for the lab '{}'", value));
    }
  } catch (const Error& error) {
    before.set({});
    throw Error::usage(fmt::format("{}: {}", file.string(), error.what()));
  }
}

void save_config(const std::filesystem::path& file, const Info& info, const params::Set& parameters) {
  std::string text = fmt::format("lab = \"{}\"\n", info.folder());
  for (const params::Parameter& p : parameters) {
    std::ostringstream value;
    if (p.type == params::Parameter::Type::toggle)
      value << std::boolalpha << (p.value() != 0);
    else if (p.is_ranged())
      value << p.text();
    else
      value << toml::value(p.text());  // in quotes
    text += fmt::format("\n# {}{}{}\n{} = {}\n", p.help, p.unit.empty() ? "" : ", in ", p.unit, p.name,
                        value.str());
  }
  write_file(file, text);
}

View find_view(const AnyLab& lab, const std::string& name) {
  std::string list;
  std::vector<std::string> names;
  for (const View view : lab.views()) {
    names.emplace_back(name_of(view));
    if (names.back() == name) return view;
    list += (list.empty() ? "" : ", ") + names.back();
  }
  if (name == name_of(View::error))
    throw Error::usage("the view 'error' needs the right answers; a student's tree does not contain them");
  throw Error::usage(fmt::format("this lab has no view '{}'; its views are {}", name, list),
                     did_you_mean(name, names));
}

params::Parameter* model_parameter(params::Set& parameters) {
  params::Parameter* model = parameters.find("model");
  return model != nullptr && model->type == params::Parameter::Type::file ? model : nullptr;
}

}  // namespace texel::app
