// SPDX-License-Identifier: MIT
// OpenGL in the browser, under the name that the labs include: OpenGL ES 3.0 as WebGL 2 has it, and what the
// labs use beyond it.
#pragma once
#include <GLES3/gl3.h>

#define GLAD_API_PTR
#define GL_TEXTURE_MAX_ANISOTROPY_EXT 0x84FE
#define GL_MAX_TEXTURE_MAX_ANISOTROPY_EXT 0x84FF

// Two switches that OpenGL ES 3.0 has not. Cube maps are always filtered across their edges. Linear values
// are always encoded when they are written into an sRGB picture: while that is off, the shader decodes them
// first (source/es_source.hpp), and the bytes are what the shader had.
#define GL_FRAMEBUFFER_SRGB 0x8DB9
#define GL_TEXTURE_CUBE_MAP_SEAMLESS 0x884F

// What only a window asks for: edges over the colours.
#define GL_COLOR_LOGIC_OP 0x0BF2
#define GL_POLYGON_OFFSET_LINE 0x2A02
#define GL_LINE 0x1B01
#define GL_FILL 0x1B02
inline void glLogicOp(GLenum) {}
inline void glPolygonMode(GLenum, GLenum) {}

namespace texel::gl {
/// glEnable and glDisable, with these two.
void switch_capability(GLenum capability, bool on);
/// glUseProgram, which tells the program whether colours are encoded.
void use_program(GLuint program);
/// glViewport, which keeps the picture's size for the programs.
void set_viewport(GLint x, GLint y, GLsizei width, GLsizei height);
/// glTexImage2D. GL_SRGB8 becomes GL_SRGB8_ALPHA8: for the first OpenGL ES makes no mipmaps.
void upload_image(GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height, GLint border,
                  GLenum format, GLenum type, const void* data);
/// glShaderSource of GLSL 3.30, and what the compiler says of it: see source/es_source.hpp.
void set_shader_text(GLuint shader, const GLchar* text);
void get_of_shader(GLuint shader, GLenum name, GLint* value);
void get_shader_log(GLuint shader, GLsizei size, GLchar* log);
/// glClearColor, in linear light.
void set_clear_color(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha);
}  // namespace texel::gl
#define glViewport(x, y, width, height) texel::gl::set_viewport(x, y, width, height)
#define glTexImage2D(target, level, internal, width, height, border, format, type, data) \
  texel::gl::upload_image(target, level, internal, width, height, border, format, type, data)
#define glEnable(capability) texel::gl::switch_capability(capability, true)
#define glDisable(capability) texel::gl::switch_capability(capability, false)
#define glClearColor(red, green, blue, alpha) texel::gl::set_clear_color(red, green, blue, alpha)
#define glShaderSource(shader, count, texts, lengths) texel::gl::set_shader_text(shader, *(texts))
#define glGetShaderiv(shader, name, value) texel::gl::get_of_shader(shader, name, value)
#define glGetShaderInfoLog(shader, size, length, log) texel::gl::get_shader_log(shader, size, log)
#define glUseProgram(program) texel::gl::use_program(program)

// Every browser that has WebGL 2 has it, and the worker asks for it; without it the limit reads as 0 or 1.
#define GLAD_GL_EXT_texture_filter_anisotropic 1
