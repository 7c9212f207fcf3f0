// SPDX-License-Identifier: MIT
#include "params/set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "core/error.hpp"

namespace texel::params {
namespace {

using Type = Parameter::Type;

std::vector<std::string> names(const auto& list) {
  std::vector<std::string> names;
  for (const auto& one : list) names.emplace_back(one.name);
  return names;
}

}  // namespace

std::string shell_quoted(const std::string& text) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./+:,";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string Parameter::text() const {
  if (type == Type::toggle) return value() != 0 ? "on" : "off";
  if (type == Type::choice) return items[static_cast<std::size_t>(value())].name;
  if (type == Type::file) return *static_cast<const std::string*>(variable_);
  return fmt::format("{}", static_cast<float>(value()));
}

void Parameter::set(std::string_view text) {
  const auto refusal = [&](const std::string& taken, const std::string& remedy = {}) {
    return Error::usage(fmt::format("--{} takes {}, not '{}'", flag(), taken, text), remedy);
  };
  if (type == Type::toggle) {
    const bool on = text == "on" || text == "true";
    if (!on && text != "off" && text != "false") throw refusal("on or off");
    set_value(on ? 1 : 0);
  } else if (type == Type::choice) {
    const std::vector<std::string> known = names(items);
    const auto item = std::find(known.begin(), known.end(), text);
    if (item == known.end())
      throw refusal(fmt::format("one of {}", fmt::join(known, ", ")), did_you_mean(text, known));
    set_value(static_cast<double>(item - known.begin()));
  } else if (type == Type::file) {
    if (text.empty())
      throw Error::usage(
          fmt::format("--{} takes one of {}, or a path", flag(), fmt::join(names(items), ", ")));
    *static_cast<std::string*>(variable_) = text;
  } else {
    float number = 0;
    if (text.starts_with('+')) text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = type == Type::number || number == std::floor(number);
    const bool inside = static_cast<double>(number) >= least && static_cast<double>(number) <= most;
    // The bounds are doubles: 0.1F lies a little outside of [0.1, 1], and is meant to be in it.
    const bool at_bound = number == static_cast<float>(least) || number == static_cast<float>(most);
    if (error != std::errc{} || end != text.data() + text.size() || !whole || !(inside || at_bound))
      throw refusal(fmt::format("{} from {} to {}{}{}", type == Type::integer ? "a whole number" : "a number",
                                least, most, unit.empty() ? "" : " ", unit));
    set_value(static_cast<double>(number));
  }
}

std::string Parameter::flag() const {
  std::string result(name);
  std::replace(result.begin(), result.end(), '_', '-');
  return result;
}

std::string_view Parameter::type_name() const {
  constexpr std::string_view kNames[] = {"toggle", "integer", "number", "choice", "file"};
  return kNames[static_cast<std::size_t>(type)];
}

void Set::append(Parameter parameter, std::string_view initial) {
  if (find(parameter.name) != nullptr)
    throw std::logic_error(fmt::format("two parameters are called '{}'", parameter.name));
  parameter.section = section_;
  parameter.set(initial);
  parameter.initial_ = parameter.text();  // of the variable itself: it then compares equal to text()
  parameters_.push_back(std::move(parameter));
}

void Set::append(Parameter parameter, const Number& number) {
  parameter.unit = number.unit;
  parameter.least = number.least;
  parameter.most = number.most;
  parameter.scale = number.scale;
  append(std::move(parameter), fmt::format("{}", number.initial));
}

void Set::add(bool& variable, Toggle toggle) {
  Parameter parameter = numeric(Type::toggle, toggle.name, toggle.help, variable);
  parameter.most = 1;
  append(std::move(parameter), toggle.initial ? "on" : "off");
}

void Set::add(int& variable, Number number) {
  append(numeric(Type::integer, number.name, number.help, variable), number);
}

void Set::add(float& variable, Number number) {
  append(numeric(Type::number, number.name, number.help, variable), number);
}

void Set::add(std::string& variable, File file) {
  Parameter parameter(Type::file, file.name, file.help, &variable);
  parameter.items = file.items;
  append(std::move(parameter), file.initial);
}

Parameter* Set::find(std::string_view name) {
  const auto found = std::find_if(begin(), end(), [&](const Parameter& p) { return p.name == name; });
  return found == end() ? nullptr : &*found;
}

const Parameter* Set::find(std::string_view name) const {
  return const_cast<Set*>(this)->find(name);
}

Parameter& Set::at(std::string_view name) {
  if (Parameter* found = find(name)) return *found;
  throw Error::usage(fmt::format("there is no parameter '{}'", name),
                     did_you_mean(name, names(parameters_), "see --list-parameters"));
}

void Set::reset() {
  for (Parameter& p : parameters_) p.reset();
}

std::string Set::key() const {
  std::string key;
  for (const Parameter& p : parameters_)
    if (!p.is_default())
      key += fmt::format("{}{}={}", key.empty() ? "" : " ", p.name, shell_quoted(p.text()));
  return key;
}

std::string Set::flags() const {
  std::string flags;
  for (const Parameter& p : parameters_)
    if (!p.is_default())
      flags += fmt::format("{}--{} {}", flags.empty() ? "" : " ", p.flag(), shell_quoted(p.text()));
  return flags;
}

}  // namespace texel::params
