// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numbers>

#include "app/lab.hpp"
#include "core/error.hpp"
#include "core/stages.hpp"

namespace texel::app {
namespace {

using Type = params::Parameter::Type;

/// "gram-schmidt" → "GRAM_SCHMIDT"
std::string constant(std::string_view name) {
  std::string result(name);
  for (char& c : result) c = c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return result;
}

}  // namespace

std::vector<gl::Define> constants(const params::Set& parameters, View view) {
  std::vector<gl::Define> defines;
  const auto add = [&](const std::string& name, int value, std::string_view flag, std::string_view text) {
    defines.push_back({name, fmt::to_string(value), fmt::format("--{} {}", flag, text)});
  };
  for (const params::Parameter& p : parameters) {
    if (!p.is_constant()) continue;
    const std::string name = constant(p.name);
    add(name, static_cast<int>(p.value()), p.flag(), p.text());
    int index = 0;
    for (const params::Item& item : p.items)
      add(name + "_" + constant(item.name), index++, p.flag(), item.name);
  }
  add("VIEW", static_cast<int>(view), "view", name_of(view));
  for (int i = 0; i <= static_cast<int>(View::error); ++i) {
    const char* name = name_of(static_cast<View>(i));
    add("VIEW_" + constant(name), i, "view", name);
  }
  return defines;
}

std::string Info::folder() const {
  return fmt::format("{:02}_{}", number, name);
}

gl::Program& Frame::program(const std::string& stem) {
  const Stage stage("parameters");
  gl::Program& program = programs_.get(stem + ".vert", stem + ".frag", constants(parameters_, view_));
  program.use();
  if (std::find(used_.begin(), used_.end(), &program) == used_.end()) {
    program.forget_uniforms();
    used_.push_back(&program);
  }
  for (const params::Parameter& p : parameters_) {
    if (!p.is_ranged()) continue;
    const gl::Uniform* uniform = program.find(p.name);
    if (uniform == nullptr) continue;
    const double value = p.unit == "degrees" ? p.value() * std::numbers::pi / 180 : p.value();
    if (p.type == Type::number && uniform->type == GL_FLOAT)
      program.set(p.name, static_cast<float>(value));
    else if (p.type == Type::integer && uniform->type == GL_INT)
      program.set(p.name, static_cast<int>(value));
    else
      throw Error::failed(
          fmt::format("the uniform '{}' and the parameter with this name have different types", p.name),
          program.place(),
          fmt::format("declare it as 'uniform {} {};'", p.type == Type::number ? "float" : "int", p.name));
  }
  return program;
}

void Frame::check() const {
  for (const gl::Program* program : used_) program->check_uniforms();
}

}  // namespace texel::app
