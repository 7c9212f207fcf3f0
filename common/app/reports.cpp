// SPDX-License-Identifier: MIT
#include "app/reports.hpp"

#include <fmt/format.h>

#include "core/json.hpp"

namespace texel::app {
std::string shaders_as_text(const gl::ProgramCache& programs, const params::Set& parameters, View view) {
  const auto origin = [&](const std::string& uniform) {
    const params::Parameter* p = parameters.find(uniform);
    // Choices and toggles are constants.
    if (p == nullptr || p->is_constant()) return std::string("set in the lab's draw()");
    return fmt::format("--{}: {}{}", p->flag(), p->help, p->unit == "degrees" ? " (here in radians)" : "");
  };
  std::string text;
  for (const auto& [key, program] : programs.programs()) {
    if (program->name().starts_with("app/")) continue;  // shows data views
    for (const gl::ShaderSource* source : {&program->vertex(), &program->fragment()})
      text += source->readable(constants(parameters, view), origin) + "\n";
  }
  return text;
}

std::string describe(const params::Parameter& p) {
  std::string text(p.help);
  if (p.is_ranged())
    text += fmt::format("; {} to {}{}{}", p.least, p.most, p.unit.empty() ? "" : " ", p.unit);
  else if (!p.items.empty())
    text += p.type == params::Parameter::Type::file ? "; a path, or one of:" : "; one of:";
  for (const params::Item& item : p.items) text += fmt::format("\n  {}: {}", item.name, item.help);
  return text + fmt::format(" [{}]", p.initial());
}

std::string parameters_as_text(const params::Set& parameters) {
  std::string text;
  for (const params::Parameter& p : parameters)
    text += fmt::format("--{} ({}): {}\n", p.flag(), p.type_name(), describe(p));
  return text;
}

std::string parameters_as_json(const params::Set& parameters) {
  Json list = Json::array();
  for (const params::Parameter& p : parameters) {
    const Json initial = p.type == params::Parameter::Type::toggle ? Json(p.initial() == "on")
                         : p.is_ranged()                           ? parse_json(p.initial())
                                                                   : Json(p.initial());
    Json choices = Json::array();
    for (const params::Item& item : p.items) choices.push_back({{"name", item.name}, {"help", item.help}});
    list.push_back({{"name", p.name},
                    {"type", p.type_name()},
                    {"default", initial},
                    {"min", p.is_ranged() ? Json(p.least) : Json()},
                    {"max", p.is_ranged() ? Json(p.most) : Json()},
                    {"choices", choices},
                    {"unit", p.unit},
                    {"help", p.help}});
  }
  return to_text(list, 2) + "\n";
}

}  // namespace texel::app
