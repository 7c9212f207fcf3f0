// SPDX-License-Identifier: MIT
#include "gl/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "core/stages.hpp"
#include "gl/upload.hpp"

namespace texel::gl {
namespace {

/// Compiles a shader into a program, which alone keeps it.
void attach(GLuint program, GLenum stage, const ShaderSource& source, const std::vector<Define>& defines) {
  const GLuint shader = glCreateShader(stage);
  const std::string text = source.text(defines);
  const char* data = text.c_str();
  glShaderSource(shader, 1, &data, nullptr);
  glCompileShader(shader);
  GLint ok = 0, length = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
  if (ok == 0) {
    glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader, length, nullptr, log.data());
    glDeleteShader(shader);
    throw source.error(log, defines);
  }
  glAttachShader(program, shader);
  glDeleteShader(shader);  // as soon as the program is
}

bool is_sampler(GLenum type) {
  return type == GL_SAMPLER_2D || type == GL_SAMPLER_CUBE || type == GL_SAMPLER_2D_ARRAY ||
         type == GL_SAMPLER_3D;
}

/// The unit that samplers have until somebody sets them, in whatever way: no lab uses it.
GLint unset_unit() {
  return texture_units() - 2;
}

}  // namespace

Program::Program(std::shared_ptr<const ShaderSource> vertex, std::shared_ptr<const ShaderSource> fragment,
                 const std::vector<Define>& defines)
    : Program() {
  vertex_ = std::move(vertex), fragment_ = std::move(fragment);
  attach(id_, GL_VERTEX_SHADER, *vertex_, defines);
  attach(id_, GL_FRAGMENT_SHADER, *fragment_, defines);
  for (GLuint i = 0; i < std::size(kAttributeNames); ++i) glBindAttribLocation(id_, i, kAttributeNames[i]);
  glLinkProgram(id_);
  if (value_of(glGetProgramiv, id_, GL_LINK_STATUS) == 0) {
    char log[4096] = "";
    glGetProgramInfoLog(id_, sizeof log, nullptr, log);
    throw Error::failed(fmt::format("does not link: {}", fragment_->locate(log)), place());
  }

  char text[256];
  GLint size = 0;
  GLint count = value_of(glGetProgramiv, id_, GL_ACTIVE_UNIFORMS);
  for (GLint i = 0; i < count; ++i) {
    Uniform uniform;
    glGetActiveUniform(id_, static_cast<GLuint>(i), sizeof text, nullptr, &size, &uniform.type, text);
    uniform.name = text;
    if (uniform.name.starts_with(kAddedUniforms)) continue;  // the context sets it
    uniform.location = glGetUniformLocation(id_, text);
    if (uniform.location >= 0) uniforms_.push_back(std::move(uniform));
  }
  count = value_of(glGetProgramiv, id_, GL_ACTIVE_ATTRIBUTES);
  for (GLint i = 0; i < count; ++i) {
    GLenum type = 0;
    glGetActiveAttrib(id_, static_cast<GLuint>(i), sizeof text, nullptr, &size, &type, text);
    if (std::string_view(text).starts_with("gl_")) continue;
    const auto* known = std::ranges::find(kAttributeNames, std::string_view(text));
    if (known == std::end(kAttributeNames))
      throw Error::failed(fmt::format("there is no vertex attribute '{}'", text),
                          {vertex_->files().front().string()},
                          "the attributes are position, normal, texcoord, tangent, bitangent and color");
    attributes_.push_back(static_cast<Attribute>(known - std::begin(kAttributeNames)));
  }
  std::sort(attributes_.begin(), attributes_.end());

  forget_uniforms();
  glUseProgram(0);
}

void Program::forget_uniforms() {
  use();
  for (Uniform& uniform : uniforms_) {
    uniform.is_set = false;
    if (is_sampler(uniform.type)) glUniform1i(uniform.location, unset_unit());
  }
}

std::string Program::name() const {
  const std::filesystem::path& file = fragment_->files().front();
  return (file.parent_path().filename() / file.filename()).string();
}

const Uniform* Program::find(std::string_view name) const {
  const auto found = std::ranges::find(uniforms_, name, &Uniform::name);
  return found == uniforms_.end() ? nullptr : &*found;
}

Uniform* Program::to_set(std::string_view name, std::initializer_list<GLenum> types) {
  auto* uniform = const_cast<Uniform*>(find(name));
  if (uniform == nullptr) {
    if (vertex_->mentions(name) || fragment_->mentions(name)) return nullptr;
    std::vector<std::string> known;
    for (const Uniform& other : uniforms_) known.push_back(other.name);
    throw Error::failed(
        fmt::format("has no uniform '{}'", name), place(),
        "the program sets it; " + did_you_mean(name, known, "declare it, or correct its name"));
  }
  const bool fits = std::find(types.begin(), types.end(), uniform->type) != types.end() ||
                    (is_sampler(uniform->type) && *types.begin() == GL_INT);
  if (!fits)
    throw Error::failed(
        fmt::format("the shader declares the uniform '{}' with another type than the program sets", name),
        place());
  uniform->is_set = true;
  return uniform;
}

void Program::set(std::string_view name, int value) {
  const Uniform* u = to_set(name, {GL_INT, GL_BOOL});
  if (u == nullptr) return;
  if (is_sampler(u->type) && (value < 0 || value >= texture_units()))
    throw no_unit(name, fmt::to_string(value));
  glUniform1i(u->location, value);
}
void Program::set(std::string_view name, GLuint value) {
  const Uniform* u = to_set(name, {GL_INT, GL_BOOL});
  if (u != nullptr && is_sampler(u->type)) throw no_unit(name, fmt::format("an unsigned {}", value));
  if (u != nullptr) glUniform1i(u->location, static_cast<GLint>(value));
}
void Program::set_floats(std::string_view name, GLenum type, const float* values) {
  const Uniform* u = to_set(name, {type});
  if (u == nullptr) return;
  if (type == GL_FLOAT) glUniform1fv(u->location, 1, values);
  if (type == GL_FLOAT_VEC2) glUniform2fv(u->location, 1, values);
  if (type == GL_FLOAT_VEC3) glUniform3fv(u->location, 1, values);
  if (type == GL_FLOAT_VEC4) glUniform4fv(u->location, 1, values);
  if (type == GL_FLOAT_MAT3) glUniformMatrix3fv(u->location, 1, GL_FALSE, values);
  if (type == GL_FLOAT_MAT4) glUniformMatrix4fv(u->location, 1, GL_FALSE, values);
}

Error Program::no_unit(std::string_view name, const std::string& value) const {
  return Error::failed(fmt::format("the sampler '{}' is set to {}", name, value), place(),
                       "a sampler takes the number of a texture unit, as a plain 0: neither a texture's name "
                       "nor GL_TEXTURE0");
}

void Program::check_uniforms() const {
  for (const Uniform& uniform : uniforms_) {
    if (uniform.is_set) continue;
    // glUniform1i sets a sampler too.
    if (!is_sampler(uniform.type) || value_of(glGetUniformiv, id_, uniform.location) == unset_unit())
      throw Error::failed(fmt::format("the uniform '{}' is read but never set", uniform.name), place(),
                          "set it in the lab, or give it the name of one of the lab's parameters");
  }
}

ProgramCache::ProgramCache(std::filesystem::path shader_root) : root_(std::move(shader_root)) {}

std::shared_ptr<const ShaderSource> ProgramCache::source(const std::string& file) {
  auto& source = sources_[file];
  if (source == nullptr) {
    // If a file is missing, no file changes when it comes: its folder does.
    tried_.insert(tried_.end(), {root_ / file, (root_ / file).parent_path(), root_ / "lib"});
    source = std::make_shared<const ShaderSource>(root_, file);
  }
  return source;
}

Program& ProgramCache::get(const std::string& vertex, const std::string& fragment,
                           const std::vector<Define>& defines) {
  const auto key_of = [&](const std::vector<Define>& these) {
    std::string key = vertex + "\n" + fragment + variant;
    for (const Define& define : these) key.append("\n").append(define.name).append(" ").append(define.value);
    return key;
  };
  Program*& known = by_request_[key_of(defines)];
  if (known != nullptr) return *known;

  const auto vertex_source = source(vertex), fragment_source = source(fragment);
  std::vector<Define> used = defines;
  std::erase_if(used, [&](const Define& define) {
    return !vertex_source->mentions(define.name) && !fragment_source->mentions(define.name);
  });
  auto& program = programs_[key_of(used)];
  if (program == nullptr) {
    const Stage stage("compile");
    program = std::make_unique<Program>(vertex_source, fragment_source, used);
  }
  known = program.get();
  return *program;
}

void ProgramCache::clear() {
  glUseProgram(0);  // a deleted program must not stay in use: the panel would restore it
  by_request_.clear();
  programs_.clear();
  sources_.clear();
  tried_.clear();
}

std::vector<std::filesystem::path> ProgramCache::files() const {
  std::set<std::filesystem::path> files(tried_.begin(), tried_.end());
  for (const auto& [name, source] : sources_)
    if (source != nullptr) files.insert(source->files().begin(), source->files().end());
  return {files.begin(), files.end()};
}

}  // namespace texel::gl
