// SPDX-License-Identifier: MIT
#include "params/set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "core/error.hpp"

namespace texel::params {
namespace {

using Type = Parameter::Type;

std::string list(std::span<const Item> items) {
  std::string text;
  for (const Item& item : items) text += (text.empty() ? "" : ", ") + std::string(item.name);
  return text;
}

}  // namespace

std::string shell_quoted(const std::string& text) {
  const auto plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("-_./+:,").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::all_of(text.begin(), text.end(), plain)) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

double Parameter::value() const {
  switch (type) {
    case Type::toggle:
      return *std::get<bool*>(variable_) ? 1 : 0;
    case Type::integer:
      return *std::get<int*>(variable_);
    case Type::number:
      return static_cast<double>(*std::get<float*>(variable_));
    case Type::choice: {
      const Enumeration& e = std::get<Enumeration>(variable_);
      return e.get(e.variable);
    }
    case Type::file:
      break;
  }
  throw std::logic_error("a file has no number");
}

std::string Parameter::text() const {
  switch (type) {
    case Type::toggle:
      return value() != 0 ? "on" : "off";
    case Type::integer:
      return fmt::format("{}", *std::get<int*>(variable_));
    case Type::number:
      return fmt::format("{}", *std::get<float*>(variable_));
    case Type::choice:
      return items[static_cast<std::size_t>(value())].name;
    case Type::file:
      return *std::get<std::string*>(variable_);
  }
  throw std::logic_error("unknown type");
}

void Parameter::set(std::string_view text) {
  switch (type) {
    case Type::toggle:
      if (text != "on" && text != "off" && text != "true" && text != "false")
        throw Error::usage(fmt::format("--{} takes on or off, not '{}'", flag(), text));
      set_value(text == "on" || text == "true" ? 1 : 0);
      return;
    case Type::integer:
    case Type::number: {
      float number = 0;
      if (text.starts_with('+')) text.remove_prefix(1);
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
      const bool whole = type == Type::number || number == std::floor(number);
      const bool inside = static_cast<double>(number) >= least && static_cast<double>(number) <= most;
      // The bounds are doubles: 0.1f lies a little outside of [0.1, 1], and is meant to be in it.
      const bool at_bound = number == static_cast<float>(least) || number == static_cast<float>(most);
      if (error != std::errc{} || end != text.data() + text.size() || !whole || !(inside || at_bound))
        throw Error::usage(fmt::format("--{} takes {} from {} to {}{}{}, not '{}'", flag(),
                                       type == Type::integer ? "a whole number" : "a number", least, most,
                                       unit.empty() ? "" : " ", unit, text));
      set_value(static_cast<double>(number));
      return;
    }
    case Type::choice: {
      const auto item =
          std::find_if(items.begin(), items.end(), [&](const Item& i) { return text == i.name; });
      if (item == items.end()) {
        std::vector<std::string> names;
        for (const Item& i : items) names.emplace_back(i.name);
        const std::string near = nearest(std::string(text), names);
        throw Error::usage(fmt::format("--{} takes one of {}, not '{}'", flag(), list(items), text),
                           near.empty() ? "" : fmt::format("did you mean '{}'?", near));
      }
      set_value(static_cast<double>(item - items.begin()));
      return;
    }
    case Type::file:
      if (text.empty())
        throw Error::usage(fmt::format("--{} takes one of {}, or a path", flag(), list(items)));
      *std::get<std::string*>(variable_) = text;
      return;
  }
}

void Parameter::set_value(double value) {
  switch (type) {
    case Type::toggle:
      *std::get<bool*>(variable_) = value != 0;
      return;
    case Type::integer:
      *std::get<int*>(variable_) = static_cast<int>(value);
      return;
    case Type::number:
      *std::get<float*>(variable_) = static_cast<float>(value);
      return;
    case Type::choice: {
      const Enumeration& e = std::get<Enumeration>(variable_);
      e.put(e.variable, static_cast<int>(value));
      return;
    }
    case Type::file:
      break;
  }
  throw std::logic_error("a file has no number");
}

void Parameter::reset() {
  set(initial_);
}

std::string Parameter::flag() const {
  std::string result(name);
  std::replace(result.begin(), result.end(), '_', '-');
  return result;
}

std::string_view Parameter::type_name() const {
  switch (type) {
    case Type::toggle:
      return "toggle";
    case Type::integer:
      return "integer";
    case Type::number:
      return "number";
    case Type::choice:
      return "choice";
    case Type::file:
      return "file";
  }
  throw std::logic_error("unknown type");
}

Parameter& Set::append(const char* name, const char* unit, const char* help, Type type) {
  if (find(name) != nullptr) throw std::logic_error(fmt::format("two parameters are called '{}'", name));
  Parameter& parameter = parameters_.emplace_back();
  parameter.name = name;
  parameter.unit = unit;
  parameter.help = help;
  parameter.section = section_;
  parameter.type = type;
  return parameter;
}

/// The text of the default is taken from the variable itself: it then compares equal to text().
void Set::finish(Parameter& parameter, std::string_view initial) {
  parameter.set(initial);
  parameter.initial_ = parameter.text();
}

void Set::add(bool& variable, Toggle toggle) {
  Parameter& parameter = append(toggle.name, "", toggle.help, Type::toggle);
  parameter.variable_ = &variable;
  parameter.most = 1;
  finish(parameter, toggle.initial ? "on" : "off");
}

void Set::add(int& variable, Number number) {
  add_number(&variable, number, Type::integer);
}

void Set::add(float& variable, Number number) {
  add_number(&variable, number, Type::number);
}

template <class Variable>
void Set::add_number(Variable* variable, const Number& number, Type type) {
  Parameter& parameter = append(number.name, number.unit, number.help, type);
  parameter.variable_ = variable;
  parameter.least = number.least;
  parameter.most = number.most;
  parameter.scale = number.scale;
  finish(parameter, fmt::format("{}", number.initial));
}

void Set::add(std::string& variable, File file) {
  Parameter& parameter = append(file.name, "", file.help, Type::file);
  parameter.variable_ = &variable;
  parameter.items = file.items;
  finish(parameter, file.initial);
}

void Set::add_choice(Parameter::Enumeration variable, const char* name, int initial,
                     std::span<const Item> items, const char* help) {
  Parameter& parameter = append(name, "", help, Type::choice);
  parameter.variable_ = variable;
  parameter.items = items;
  parameter.most = static_cast<double>(items.size()) - 1;
  finish(parameter, items[static_cast<std::size_t>(initial)].name);
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
  std::vector<std::string> names;
  for (const Parameter& p : parameters_) names.emplace_back(p.name);
  const std::string near = nearest(std::string(name), names);
  throw Error::usage(fmt::format("there is no parameter '{}'", name),
                     near.empty() ? "see --list-parameters" : fmt::format("did you mean '{}'?", near));
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
