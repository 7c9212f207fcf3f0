// SPDX-License-Identifier: MIT
#include "gl/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/stages.hpp"

namespace texel::gl {
namespace {

Recorder* current = nullptr;

template <class T>
void add_once(std::vector<T>& list, T value) {
  if (std::find(list.begin(), list.end(), value) == list.end()) list.push_back(std::move(value));
}

std::string format_name(GLint format) {
  switch (format) {
    case GL_R8:
      return "R8";
    case GL_RG8:
      return "RG8";
    case GL_RGB8:
      return "RGB8";
    case GL_RGBA8:
      return "RGBA8";
    case GL_SRGB8:
      return "SRGB8";
    case GL_SRGB8_ALPHA8:
      return "SRGB8_ALPHA8";
    case GL_RGB16F:
      return "RGB16F";
    case GL_RGBA16F:
      return "RGBA16F";
    case GL_RGB32F:
      return "RGB32F";
    case GL_RGBA32F:
      return "RGBA32F";
    default:
      return fmt::format("0x{:04x}", format);
  }
}

int bytes_per_texel(GLint format) {
  switch (format) {
    case GL_R8:
      return 1;
    case GL_RG8:
      return 2;
    case GL_RGB8:
    case GL_SRGB8:
      return 3;
    case GL_RGB16F:
      return 6;
    case GL_RGBA16F:
      return 8;
    case GL_RGB32F:
      return 12;
    case GL_RGBA32F:
      return 16;
    default:
      return 4;
  }
}

bool minifies_with_mipmaps(GLint filter) {
  return filter != GL_NEAREST && filter != GL_LINEAR;
}

}  // namespace

Recorder::Recorder() : draw_arrays_(glad_glDrawArrays), draw_elements_(glad_glDrawElements) {
  current = this;
  glad_glDrawArrays = on_draw_arrays;
  glad_glDrawElements = on_draw_elements;
}

Recorder::~Recorder() {
  glad_glDrawArrays = draw_arrays_;
  glad_glDrawElements = draw_elements_;
  current = nullptr;
}

Record Recorder::take() {
  if (record_.draw_calls == 0) warn("nothing is drawn");
  return std::move(record_);
}

void Recorder::on_draw_arrays(GLenum mode, GLint first, GLsizei count) {
  current->inspect(mode, count);
  current->draw_arrays_(mode, first, count);
}

void Recorder::on_draw_elements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
  current->inspect(mode, count);
  current->inspect_indices();
  current->draw_elements_(mode, count, type, indices);
}

void Recorder::inspect(GLenum mode, GLsizei count) {
  const Stage stage("statistics");
  record_.draw_calls += 1;
  record_.triangles += mode == GL_TRIANGLES ? count / 3 : std::max(count - 2, 0);
  GLint program = 0;
  glGetIntegerv(GL_CURRENT_PROGRAM, &program);
  if (program == 0) {
    warn("a draw call without a program");
    return;
  }
  inspect_attributes(static_cast<GLuint>(program));
  inspect_samplers(static_cast<GLuint>(program));
}

void Recorder::inspect_indices() {
  GLint buffer = 0, bytes = 0;
  glGetIntegerv(GL_ELEMENT_ARRAY_BUFFER_BINDING, &buffer);
  if (buffer == 0 || !index_buffers_.insert(buffer).second) return;
  glGetBufferParameteriv(GL_ELEMENT_ARRAY_BUFFER, GL_BUFFER_SIZE, &bytes);
  record_.index_bytes += bytes;
}

void Recorder::inspect_attributes(GLuint program) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_VERTEX_ATTRIBS, &most);
  std::vector<std::string> names(static_cast<std::size_t>(most));
  GLint count = 0;
  glGetProgramiv(program, GL_ACTIVE_ATTRIBUTES, &count);
  for (GLint i = 0; i < count; ++i) {
    char name[256];
    GLint size = 0;
    GLenum type = 0;
    glGetActiveAttrib(program, static_cast<GLuint>(i), sizeof name, nullptr, &size, &type, name);
    const GLint location = glGetAttribLocation(program, name);
    if (location >= 0 && location < most) names[static_cast<std::size_t>(location)] = name;
  }
  GLint restore = 0;
  glGetIntegerv(GL_ARRAY_BUFFER_BINDING, &restore);
  for (GLint i = 0; i < most; ++i) {
    const auto location = static_cast<GLuint>(i);
    const std::string& name = names[location];
    GLint enabled = 0;
    glGetVertexAttribiv(location, GL_VERTEX_ATTRIB_ARRAY_ENABLED, &enabled);
    if (enabled == 0) {
      if (!name.empty())
        warn(fmt::format("the shader reads the attribute '{}', but no array is enabled for it", name));
      continue;
    }
    if (name.empty()) continue;  // the array costs nothing
    GLint buffer = 0, bytes = 0, components = 0, stride = 0;
    glGetVertexAttribiv(location, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING, &buffer);
    glGetVertexAttribiv(location, GL_VERTEX_ATTRIB_ARRAY_SIZE, &components);
    glGetVertexAttribiv(location, GL_VERTEX_ATTRIB_ARRAY_STRIDE, &stride);
    glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(buffer));
    glGetBufferParameteriv(GL_ARRAY_BUFFER, GL_BUFFER_SIZE, &bytes);
    Record::AttributeUse use{name, bytes};
    if (std::find(record_.attributes.begin(), record_.attributes.end(), use) != record_.attributes.end())
      continue;
    record_.attributes.push_back(use);
    const GLint step = stride != 0 ? stride : components * static_cast<GLint>(sizeof(float));
    if (name == "position") record_.vertices += bytes / std::max(step, 1);
  }
  glBindBuffer(GL_ARRAY_BUFFER, static_cast<GLuint>(restore));
}

void Recorder::inspect_samplers(GLuint program) {
  GLint restore_unit = 0;
  glGetIntegerv(GL_ACTIVE_TEXTURE, &restore_unit);
  GLint count = 0;
  glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
  for (GLint i = 0; i < count; ++i) {
    char name[256];
    GLint size = 0, unit = 0, texture = 0;
    GLenum type = 0;
    glGetActiveUniform(program, static_cast<GLuint>(i), sizeof name, nullptr, &size, &type, name);
    if (type != GL_SAMPLER_2D && type != GL_SAMPLER_CUBE) continue;
    const GLenum target = type == GL_SAMPLER_2D ? GL_TEXTURE_2D : GL_TEXTURE_CUBE_MAP;
    const GLenum face = type == GL_SAMPLER_2D ? GL_TEXTURE_2D : GL_TEXTURE_CUBE_MAP_POSITIVE_X;
    glGetUniformiv(program, glGetUniformLocation(program, name), &unit);
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glGetIntegerv(type == GL_SAMPLER_2D ? GL_TEXTURE_BINDING_2D : GL_TEXTURE_BINDING_CUBE_MAP, &texture);
    if (texture == 0) {
      warn(fmt::format("the sampler '{}' reads unit {}, but no texture is bound there", name, unit));
      continue;
    }
    GLint filter = 0;
    glGetTexParameteriv(target, GL_TEXTURE_MIN_FILTER, &filter);
    Record::TextureUse use;
    use.name = name;
    use.id = static_cast<GLuint>(texture);
    use.is_cube = type == GL_SAMPLER_CUBE;
    GLint format = 0;
    glGetTexLevelParameteriv(face, 0, GL_TEXTURE_WIDTH, &use.width);
    glGetTexLevelParameteriv(face, 0, GL_TEXTURE_HEIGHT, &use.height);
    glGetTexLevelParameteriv(face, 0, GL_TEXTURE_INTERNAL_FORMAT, &format);
    if (use.width == 0) {
      warn(fmt::format("the texture of the sampler '{}' on unit {} has no image", name, unit));
      continue;
    }
    use.format = format_name(format);
    const int levels = 1 + static_cast<int>(std::log2(std::max(use.width, use.height)));
    int present = 0;
    for (; present < levels; ++present) {
      GLint width = 0, height = 0;
      glGetTexLevelParameteriv(face, present, GL_TEXTURE_WIDTH, &width);
      glGetTexLevelParameteriv(face, present, GL_TEXTURE_HEIGHT, &height);
      if (width == 0) break;
      use.bytes +=
          static_cast<long long>(width) * height * bytes_per_texel(format) * (type == GL_SAMPLER_2D ? 1 : 6);
    }
    GLint last = 0;
    glGetTexParameteriv(target, GL_TEXTURE_MAX_LEVEL, &last);
    use.levels = std::min(present, last + 1);
    if (minifies_with_mipmaps(filter) && present < std::min(levels, last + 1))
      warn(fmt::format(
          "the sampler '{}' minifies with mipmaps, but its texture has only {} of {} levels: it reads black",
          name, present, levels));
    add_once(record_.textures, use);
  }
  glActiveTexture(static_cast<GLenum>(restore_unit));
}

void Recorder::warn(const std::string& text) {
  add_once(record_.warnings, text);
}

}  // namespace texel::gl
