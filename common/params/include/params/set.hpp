// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

/// One declaration of a parameter serves the panel, the command line, the key of a snapshot and the GLSL
/// uniform.
///
///     struct Parameters {
///       Method method{};
///       float tilt{};
///       void declare(params::Set& set) {
///         set.add(method, {"method", Method::trilinear, methods, "How the texture is filtered"});
///         set.add(tilt, {"tilt", 60, -89, 89, "degrees", "How far the quad leans back"});
///       }
///     };
///
/// The descriptions are made by consteval constructors: a name that is not snake_case, an empty help or a
/// default out of range does not compile.
namespace texel::params {

/// One of the values of a choice: its name in kebab-case and one line of help.
struct Item {
  const char* name;
  const char* help;
};

namespace detail {

consteval void check(std::string_view name, std::string_view help) {
  constexpr std::string_view allowed = "abcdefghijklmnopqrstuvwxyz0123456789_";
  if (name.empty() || name.front() < 'a' || name.back() == '_' ||
      name.find_first_not_of(allowed) != name.npos)
    throw "a parameter's name is snake_case: lower-case letters, digits, underscores";
  if (help.empty()) throw "a parameter needs a line of help";
}

consteval void check_items(std::span<const Item> items) {
  if (items.empty()) throw "a choice needs at least one item";
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (std::string_view(items[i].name).empty() || std::string_view(items[i].help).empty())
      throw "an item needs a name and a line of help";
    for (std::size_t j = 0; j < i; ++j)
      if (std::string_view(items[i].name) == items[j].name) throw "two items have the same name";
  }
}

}  // namespace detail

/// How a slider moves: evenly, or evenly in the logarithm.
enum class Scale { linear, logarithmic };

/// On or off.
struct Toggle {
  const char *name, *help;
  bool initial;
  consteval Toggle(const char* name_, bool initial_, const char* help_)
      : name(name_), help(help_), initial(initial_) {
    detail::check(name, help);
  }
};

/// A number within [least, most]. In GLSL a uniform of the same name, where "degrees" arrive as radians.
struct Number {
  double initial, least, most;  // first: Clang 14 forgets the gap that 32-bit pointers need before them
  const char *name, *unit, *help;
  Scale scale;
  consteval Number(const char* name_, double initial_, double least_, double most_, const char* unit_,
                   const char* help_, Scale scale_ = Scale::linear)
      : initial(initial_), least(least_), most(most_), name(name_), unit(unit_), help(help_), scale(scale_) {
    detail::check(name, help);
    if (!(least < most)) throw "a range goes from a smaller to a larger value";
    if (!(least <= initial && initial <= most)) throw "the default is outside the range";
    if (scale == Scale::logarithmic && !(least > 0)) throw "a logarithmic range must be positive";
  }
};

/// One of an enumeration's values, which count from 0 in the order of `items`. In GLSL a constant for `#if`.
template <class Enum>
struct Choice {
  const char *name, *help;
  Enum initial;
  std::span<const Item> items;
  consteval Choice(const char* name_, Enum initial_, std::span<const Item> items_, const char* help_)
      : name(name_), help(help_), initial(initial_), items(items_) {
    detail::check(name, help);
    detail::check_items(items);
    if (static_cast<std::size_t>(initial) >= items.size()) throw "the default is not one of the items";
  }
};

/// One of the bundled files by its name, or the path of any other file.
struct File {
  const char *name, *initial, *help;
  std::span<const Item> items;
  consteval File(const char* name_, const char* initial_, std::span<const Item> items_, const char* help_)
      : name(name_), initial(initial_), help(help_), items(items_) {
    detail::check(name, help);
    detail::check_items(items);
    bool found = false;
    for (const Item& item : items) found = found || std::string_view(item.name) == initial;
    if (!found) throw "the default is not one of the items";
  }
};

/// A value as a shell takes it: in single quotes only where it must be.
std::string shell_quoted(const std::string& text);

/// A parameter at run time: its description and the variable it stands for.
class Parameter {
 public:
  enum class Type { toggle, integer, number, choice, file };

  Type type;
  std::string_view name, help, unit;
  std::string_view section;    ///< heading under which the panel shows it
  double least = 0, most = 0;  ///< range of an integer or number; for a choice 0 and the last item
  Scale scale = Scale::linear;
  std::span<const Item> items;  ///< of a choice or file

  /// A toggle as 0 or 1, an integer or number as it is, a choice as its index. Not for files.
  [[nodiscard]] double value() const { return get_(variable_); }
  /// The value as the command line takes it: "on", "12.5", "gram-schmidt", "brick".
  [[nodiscard]] std::string text() const;
  /// Throws Error (usage) that names the range, unit or choices.
  void set(std::string_view text);
  /// As set(text), for a value that already lies within the range (a slider's). Not for files.
  void set_value(double value) { put_(variable_, value); }
  void reset() { set(initial_); }
  [[nodiscard]] bool is_default() const { return text() == initial_; }
  [[nodiscard]] std::string initial() const { return initial_; }
  /// The name on the command line: "bump_strength" is --bump-strength.
  [[nodiscard]] std::string flag() const;
  [[nodiscard]] std::string_view type_name() const;
  /// Whether it is a constant in shaders; an integer or number is a uniform there.
  [[nodiscard]] bool is_constant() const { return type == Type::toggle || type == Type::choice; }
  [[nodiscard]] bool is_ranged() const { return type == Type::integer || type == Type::number; }

 private:
  friend class Set;
  Parameter(Type type_, const char* name_, const char* help_, void* variable)
      : type(type_), name(name_), help(help_), variable_(variable) {}
  void* variable_;
  double (*get_)(const void* variable) = nullptr;  ///< not of a file
  void (*put_)(void* variable, double value) = nullptr;
  std::string initial_;
};

/// The parameters of one struct, in the order of their declaration. Refers to the struct: it must outlive the
/// set.
class Set {
 public:
  /// Headings for the panel: every parameter added after it stands below.
  void section(const char* title) { section_ = title; }
  void add(bool& variable, Toggle toggle);
  void add(int& variable, Number number);
  void add(float& variable, Number number);
  void add(std::string& variable, File file);
  template <class Enum>
  requires std::is_enum_v<Enum>
  void add(Enum& variable, Choice<std::type_identity_t<Enum>> choice) {
    Parameter parameter = numeric(Parameter::Type::choice, choice.name, choice.help, variable);
    parameter.items = choice.items;
    parameter.most = static_cast<double>(choice.items.size()) - 1;
    append(std::move(parameter), choice.items[static_cast<std::size_t>(choice.initial)].name);
  }

  [[nodiscard]] Parameter* find(std::string_view name);
  [[nodiscard]] const Parameter* find(std::string_view name) const;
  /// As find, but throws Error (usage) with the nearest name.
  [[nodiscard]] Parameter& at(std::string_view name);
  void reset();
  /// The values that are not the defaults, in declaration order: "method=nearest tilt=80"; "" for the default
  /// look.
  [[nodiscard]] std::string key() const;
  /// The same as command-line flags: "--method nearest --tilt 80", quoted for a shell.
  [[nodiscard]] std::string flags() const;

  [[nodiscard]] auto begin() { return parameters_.begin(); }
  [[nodiscard]] auto end() { return parameters_.end(); }
  [[nodiscard]] auto begin() const { return parameters_.begin(); }
  [[nodiscard]] auto end() const { return parameters_.end(); }

 private:
  /// Of any type but a file: its values are numbers.
  template <class Variable>
  static Parameter numeric(Parameter::Type type, const char* name, const char* help, Variable& variable) {
    Parameter parameter(type, name, help, &variable);
    parameter.get_ = [](const void* v) { return static_cast<double>(*static_cast<const Variable*>(v)); };
    parameter.put_ = [](void* v, double value) { *static_cast<Variable*>(v) = static_cast<Variable>(value); };
    return parameter;
  }
  void append(Parameter parameter, const Number& number);
  void append(Parameter parameter, std::string_view initial);
  std::vector<Parameter> parameters_;
  const char* section_ = "";
};

}  // namespace texel::params
