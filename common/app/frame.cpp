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
  for (const params::Parameter& p : parameters) {
    if (!p.is_constant()) continue;
    const std::string name = constant(p.name);
    defines.push_back(
        {name, fmt::format("{}", static_cast<int>(p.value())), fmt::format("--{} {}", p.flag(), p.text())});
    for (std::size_t i = 0; i < p.items.size(); ++i)
      defines.push_back({fmt::format("{}_{}", name, constant(p.items[i].name)), fmt::format("{}", i),
                         fmt::format("--{} {}", p.flag(), p.items[i].name)});
  }
  defines.push_back(
      {"VIEW", fmt::format("{}", static_cast<int>(view)), fmt::format("--view {}", name_of(view))});
  for (int i = 0; i <= static_cast<int>(View::error); ++i) {
    const char* name = name_of(static_cast<View>(i));
    defines.push_back(
        {fmt::format("VIEW_{}", constant(name)), fmt::format("{}", i), fmt::format("--view {}", name)});
  }
  return defines;
}

std::string Info::folder() const {
  return fmt::format("{:02}_{}", number, name);
}
std::string Info::program() const {
  return "lab" + folder();
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
