// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
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

consteval bool is_snake_case(std::string_view name) {
  if (name.empty() || name.front() < 'a' || name.front() > 'z' || name.back() == '_') return false;
  for (const char c : name)
    if (!((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_')) return false;
  return true;
}

consteval void check(std::string_view name, std::string_view help) {
  if (!is_snake_case(name)) throw "a parameter's name is snake_case: lower-case letters, digits, underscores";
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

  std::string_view name, unit, help;
  std::string_view section;  ///< heading under which the panel shows it
  Type type;
  double least = 0, most = 0;  ///< range of an integer or number; for a choice 0 and the last item
  Scale scale = Scale::linear;
  std::span<const Item> items;  ///< of a choice or file

  /// A toggle as 0 or 1, an integer or number as it is, a choice as its index. Not for files.
  [[nodiscard]] double value() const;
  /// The value as the command line takes it: "on", "12.5", "gram-schmidt", "brick".
  [[nodiscard]] std::string text() const;
  /// Throws Error (usage) that names the range, unit or choices.
  void set(std::string_view text);
  /// As set(text), for a value that already lies within the range (a slider's).
  void set_value(double value);
  void reset();
  [[nodiscard]] bool is_default() const { return text() == initial_; }
  [[nodiscard]] std::string initial() const { return initial_; }
  /// The name on the command line: "bump_strength" is --bump-strength.
  [[nodiscard]] std::string flag() const;
  [[nodiscard]] std::string_view type_name() const;

 private:
  friend class Set;
  struct Enumeration {
    void* variable;
    int (*get)(const void*);
    void (*put)(void*, int);
  };
  std::variant<bool*, int*, float*, std::string*, Enumeration> variable_;
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
    add_choice({&variable, [](const void* v) { return static_cast<int>(*static_cast<const Enum*>(v)); },
                [](void* v, int i) { *static_cast<Enum*>(v) = static_cast<Enum>(i); }},
               choice.name, static_cast<int>(choice.initial), choice.items, choice.help);
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
  void add_choice(Parameter::Enumeration variable, const char* name, int initial, std::span<const Item> items,
                  const char* help);
  template <class Variable>
  void add_number(Variable* variable, const Number& number, Parameter::Type type);
  Parameter& append(const char* name, const char* unit, const char* help, Parameter::Type type);
  void finish(Parameter& parameter, std::string_view initial);
  std::vector<Parameter> parameters_;
  const char* section_ = "";
};

}  // namespace texel::params
