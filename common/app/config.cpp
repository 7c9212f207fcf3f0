// SPDX-License-Identifier: MIT
#include "app/config.hpp"

#include <fmt/format.h>

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

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

}  // namespace

void load_config(const std::filesystem::path& file, const Info& info, params::Set& parameters) {
  const std::string text = read_file(file);
  toml::table table;
  try {
    table = toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    throw Error::failed(std::string(error.description()),
                        {file.string(), static_cast<int>(error.source().begin.line),
                         static_cast<int>(error.source().begin.column)},
                        "write lines 'name = value', as --save-config does");
  }
  std::vector<std::string> before;
  for (const params::Parameter& p : parameters) before.push_back(p.text());
  try {
    for (const auto& [key, node] : table) {
      if (key.str() == "lab") {
        if (node.value_or(std::string()) != info.folder())
          throw Error::usage(fmt::format("the file is for the lab '{}'", node.value_or(std::string())));
        continue;
      }
      parameters.at(key.str()).set(as_text(node));
    }
  } catch (const Error& error) {
    auto old = before.begin();
    for (params::Parameter& p : parameters) p.set(*old++);
    throw Error::usage(fmt::format("{}: {}", file.string(), error.what()));
  }
}

void save_config(const std::filesystem::path& file, const Info& info, const params::Set& parameters) {
  std::string text = fmt::format("lab = \"{}\"\n", info.folder());
  for (const params::Parameter& p : parameters) {
    const bool word = p.type == params::Parameter::Type::choice || p.type == params::Parameter::Type::file;
    const bool toggle = p.type == params::Parameter::Type::toggle;
    std::string value = word ? quoted(p.text()) : toggle ? (p.value() != 0 ? "true" : "false") : p.text();
    text +=
        fmt::format("\n# {}{}{}\n{} = {}\n", p.help, p.unit.empty() ? "" : ", in ", p.unit, p.name, value);
  }
  write_file(file, text);
}

}  // namespace texel::app
