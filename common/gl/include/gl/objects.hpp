// SPDX-License-Identifier: MIT
#pragma once
#include <glad/gl.h>

#include <utility>

namespace texel::gl {

/// What the context has by this name, as GL_MAX_SAMPLES.
inline GLint integer(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

/// Owns one OpenGL object: made by the constructor, deleted by the destructor, moved but not copied. The
/// context in which it was made must be current.
template <class Kind>
class Object {
 public:
  Object() { Kind::create(&id_); }
  ~Object() {
    if (id_ != 0) Kind::destroy(&id_);
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

namespace detail {
#define TEXEL_GL_KIND(Name, plural)                              \
  struct Name {                                                  \
    static void create(GLuint* id) { glGen##plural(1, id); }     \
    static void destroy(GLuint* id) { glDelete##plural(1, id); } \
  };
TEXEL_GL_KIND(BufferKind, Buffers)
TEXEL_GL_KIND(VertexArrayKind, VertexArrays)
TEXEL_GL_KIND(TextureKind, Textures)
TEXEL_GL_KIND(FramebufferKind, Framebuffers)
TEXEL_GL_KIND(RenderbufferKind, Renderbuffers)
TEXEL_GL_KIND(QueryKind, Queries)
#undef TEXEL_GL_KIND
}  // namespace detail

using Buffer = Object<detail::BufferKind>;
using VertexArray = Object<detail::VertexArrayKind>;
using Texture = Object<detail::TextureKind>;
using Framebuffer = Object<detail::FramebufferKind>;
using Renderbuffer = Object<detail::RenderbufferKind>;
using Query = Object<detail::QueryKind>;

}  // namespace texel::gl
