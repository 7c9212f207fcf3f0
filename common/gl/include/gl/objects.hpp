// SPDX-License-Identifier: MIT
#pragma once
#include <glad/gl.h>

#include <utility>

namespace texel::gl {

/// What a function of OpenGL says of an object: value_of(glGetProgramiv, program, GL_LINK_STATUS).
template <class Object, class Name>
GLint value_of(void(GLAD_API_PTR* query)(Object, Name, GLint*), std::type_identity_t<Object> object,
               std::type_identity_t<Name> name) {
  GLint value = 0;
  query(object, name, &value);
  return value;
}

/// What the context has by this name, as GL_MAX_SAMPLES.
inline GLint integer(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

/// Owns one OpenGL object: made by the constructor, deleted by the destructor, moved but not copied. The
/// context in which it was made must be current.
template <auto& create, auto& destroy>
class Object {
 public:
  Object() { create(1, &id_); }
  ~Object() {
    if (id_ != 0) destroy(1, &id_);
  }
  Object(Object&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  Object& operator=(Object&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  [[nodiscard]] GLuint id() const { return id_; }

 private:
  GLuint id_ = 0;
};

using Buffer = Object<glGenBuffers, glDeleteBuffers>;
using VertexArray = Object<glGenVertexArrays, glDeleteVertexArrays>;
using Texture = Object<glGenTextures, glDeleteTextures>;
using Framebuffer = Object<glGenFramebuffers, glDeleteFramebuffers>;
using Renderbuffer = Object<glGenRenderbuffers, glDeleteRenderbuffers>;
using Query = Object<glGenQueries, glDeleteQueries>;

}  // namespace texel::gl
