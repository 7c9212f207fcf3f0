// SPDX-License-Identifier: MIT
#include "gl/recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/stages.hpp"
#include "gl/program.hpp"

namespace texel::gl {
namespace {

Recorder* current = nullptr;

/// Whether it was not yet there.
template <class T>
bool add_once(std::vector<T>& list, T value) {
  if (std::find(list.begin(), list.end(), value) != list.end()) return false;
  list.push_back(std::move(value));
  return true;
}

/// A texture's format as OpenGL calls it, and the bytes of one texel.
struct FormatUse {
  GLint format;
  const char* name;
  int bytes;
};
constexpr FormatUse kFormats[] = {{GL_R8, "R8", 1},           {GL_RG8, "RG8", 2},
                                  {GL_RGB8, "RGB8", 3},       {GL_SRGB8, "SRGB8", 3},
                                  {GL_RGBA8, "RGBA8", 4},     {GL_SRGB8_ALPHA8, "SRGB8_ALPHA8", 4},
                                  {GL_RGBA32F, "RGBA32F", 16}};

FormatUse use_of(GLint format) {
  const auto* known = std::ranges::find(kFormats, format, &FormatUse::format);
  return known != std::end(kFormats) ? *known : FormatUse{format, "other", 4};
}

GLint integer_of_level(GLenum face, GLint level, GLenum name) {
  GLint value = 0;
  glGetTexLevelParameteriv(face, level, name, &value);
  return value;
}

void warn(Record& record, const std::string& text) {
  add_once(record.warnings, text);
}

void inspect_attributes(Record& record, GLuint program) {
  for (const char* name : kAttributeNames) {
    const GLint at = glGetAttribLocation(program, name);
    if (at < 0) continue;
    const auto location = static_cast<GLuint>(at);
    if (value_of(glGetVertexAttribiv, location, GL_VERTEX_ATTRIB_ARRAY_ENABLED) == 0) {
      warn(record, fmt::format("the shader reads the attribute '{}', but no array is enabled for it", name));
      continue;
    }
    const GLint buffer = value_of(glGetVertexAttribiv, location, GL_VERTEX_ATTRIB_ARRAY_BUFFER_BINDING),
                components = value_of(glGetVertexAttribiv, location, GL_VERTEX_ATTRIB_ARRAY_SIZE);
    glBindBuffer(GL_COPY_READ_BUFFER, static_cast<GLuint>(buffer));  // which nothing else uses
    const GLint bytes = value_of(glGetBufferParameteriv, GL_COPY_READ_BUFFER, GL_BUFFER_SIZE);
    if (!add_once(record.attributes, {name, bytes})) continue;
    const GLint step = components * static_cast<GLint>(sizeof(float));  // ours follow without a gap
    if (name == std::string_view("position")) record.vertices += bytes / step;
  }
}

void inspect_samplers(Record& record, GLuint program) {
  const auto restore_unit = static_cast<GLenum>(integer(GL_ACTIVE_TEXTURE));
  const GLint count = value_of(glGetProgramiv, program, GL_ACTIVE_UNIFORMS);
  for (GLint i = 0; i < count; ++i) {
    char name[256];
    GLint size = 0;
    GLenum type = 0;
    glGetActiveUniform(program, static_cast<GLuint>(i), sizeof name, nullptr, &size, &type, name);
    if (type != GL_SAMPLER_2D && type != GL_SAMPLER_CUBE) continue;
    const bool is_cube = type == GL_SAMPLER_CUBE;
    const GLenum target = is_cube ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D;
    const GLenum face = is_cube ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : GL_TEXTURE_2D;
    const GLint unit = value_of(glGetUniformiv, program, glGetUniformLocation(program, name));
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    const GLint texture = integer(is_cube ? GL_TEXTURE_BINDING_CUBE_MAP : GL_TEXTURE_BINDING_2D);
    if (texture == 0) {
      warn(record, fmt::format("the sampler '{}' reads unit {}, but no texture is bound there", name, unit));
      continue;
    }
    const GLint filter = value_of(glGetTexParameteriv, target, GL_TEXTURE_MIN_FILTER),
                last = value_of(glGetTexParameteriv, target, GL_TEXTURE_MAX_LEVEL);
    const FormatUse format = use_of(integer_of_level(face, 0, GL_TEXTURE_INTERNAL_FORMAT));
    Record::TextureUse use{.name = name,
                           .id = static_cast<GLuint>(texture),
                           .is_cube = is_cube,
                           .width = integer_of_level(face, 0, GL_TEXTURE_WIDTH),
                           .height = integer_of_level(face, 0, GL_TEXTURE_HEIGHT),
                           .format = format.name};
    if (use.width == 0) {
      warn(record, fmt::format("the texture of the sampler '{}' on unit {} has no image", name, unit));
      continue;
    }
    const int levels = 1 + static_cast<int>(std::log2(std::max(use.width, use.height)));
    int present = 0;
    for (; present < levels; ++present) {
      const GLint width = integer_of_level(face, present, GL_TEXTURE_WIDTH);
      if (width == 0) break;
      use.bytes += static_cast<long long>(width) * integer_of_level(face, present, GL_TEXTURE_HEIGHT) *
                   format.bytes * (is_cube ? 6 : 1);
    }
    use.levels = std::min(present, last + 1);
    const bool reads_levels = filter != GL_NEAREST && filter != GL_LINEAR;
    if (reads_levels && present < std::min(levels, last + 1))
      warn(record, fmt::format("the sampler '{}' minifies with mipmaps, but its texture has only {} of {} "
                               "levels: it reads black",
                               name, present, levels));
    add_once(record.textures, use);
  }
  glActiveTexture(restore_unit);
}

void inspect(Record& record, GLenum mode, GLsizei count) {
  const Stage stage("statistics");
  record.draw_calls += 1;
  record.triangles += mode == GL_TRIANGLES ? count / 3 : std::max(count - 2, 0);
  const auto program = static_cast<GLuint>(integer(GL_CURRENT_PROGRAM));
  if (program == 0) return warn(record, "a draw call without a program");
  inspect_attributes(record, program);
  inspect_samplers(record, program);
}

}  // namespace

Recorder::Recorder() : draw_arrays_(glad_glDrawArrays), draw_elements_(glad_glDrawElements) {
  current = this;
  glad_glDrawArrays = [](GLenum mode, GLint first, GLsizei count) {
    inspect(current->record_, mode, count);
    current->draw_arrays_(mode, first, count);
  };
  glad_glDrawElements = [](GLenum mode, GLsizei count, GLenum type, const void* indices) {
    inspect(current->record_, mode, count);
    const GLint buffer = integer(GL_ELEMENT_ARRAY_BUFFER_BINDING);
    if (buffer != 0 && current->index_buffers_.insert(buffer).second)
      current->record_.index_bytes +=
          value_of(glGetBufferParameteriv, GL_ELEMENT_ARRAY_BUFFER, GL_BUFFER_SIZE);
    current->draw_elements_(mode, count, type, indices);
  };
}

Recorder::~Recorder() {
  glad_glDrawArrays = draw_arrays_;
  glad_glDrawElements = draw_elements_;
  current = nullptr;
}

Record Recorder::take() {
  if (record_.draw_calls == 0) warn(record_, "nothing is drawn");
  return std::move(record_);
}

}  // namespace texel::gl
