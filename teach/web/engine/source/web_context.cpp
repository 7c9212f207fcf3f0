// SPDX-License-Identifier: MIT
// WebGL 2, whose context the page's worker has made current. In place of context.cpp.
#include <fmt/format.h>
#include <glad/gl.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "es_source.hpp"
#include "gl/context.hpp"
#include "gl/program.hpp"
#include "image/color.hpp"
#include "web_context.hpp"

namespace texel::gl {
namespace {

constexpr GLenum kUnmaskedRenderer = 0x9246;  // WEBGL_debug_renderer_info

bool encodes = true;  ///< GL_FRAMEBUFFER_SRGB
float shift_x = 0, shift_y = 0;
bool is_preview = false;
GLsizei width = 1, height = 1;  ///< of the viewport, which is the whole picture

void tell(GLuint program) {
  if (program == 0) return;
  glUniform1i(glGetUniformLocation(program, kKeepsBytes), encodes ? 0 : 1);
  glUniform2f(glGetUniformLocation(program, kShift), shift_x, shift_y);
  glUniform2f(glGetUniformLocation(program, kPictureSize), static_cast<float>(width),
              static_cast<float>(height));
}

/// What draws, as far as the browser tells.
std::string renderer_name() {
  const auto* name = reinterpret_cast<const char*>(glGetString(kUnmaskedRenderer));
  static_cast<void>(glGetError());  // where the browser does not tell
  return name != nullptr ? name : reinterpret_cast<const char*>(glGetString(GL_RENDERER));
}

/// Whether a renderer that draws with the processor reads such textures better as floats. No page can tell it
/// how to read them (gl::Shaders). Mesa's llvmpipe filters bytes that are no colours in 8 bits, up to 10 of
/// their steps off. SwiftShader decodes each texel that it filters by a power function, roughly: with floats
/// lab 9's ball takes two thirds of the time, and its colours differ by one level in 0.1 % of the pixels.
bool reads_floats_better(GLint internal) {
  static const std::string name = renderer_name();
  const char* renderer = internal == GL_RGB8 ? "llvmpipe" : internal == GL_SRGB8 ? "SwiftShader" : nullptr;
  return renderer != nullptr && name.find(renderer) != std::string::npos;
}

/// What the compiler says of a shader; its own text has so many bytes.
std::string message_of(GLuint shader, GLint bytes) {
  std::string log(static_cast<std::size_t>(std::max(bytes, 1)), '\0');
  (glGetShaderInfoLog)(shader, bytes, nullptr, log.data());
  return es_message(log.substr(0, log.find('\0')));
}

class WebContext : public Context {
 public:
  WebContext() : Context(Shaders::quick_to_draw) {}
};

}  // namespace

void switch_capability(GLenum capability, bool on) {
  if (capability == GL_TEXTURE_CUBE_MAP_SEAMLESS) return;  // always on
  if (capability != GL_FRAMEBUFFER_SRGB) {
    (on ? glEnable : glDisable)(capability);
    return;
  }
  encodes = on;
  tell(static_cast<GLuint>(integer(GL_CURRENT_PROGRAM)));
}

void use_program(GLuint program) {
  (glUseProgram)(program);
  tell(program);
}

int subpixel_bits() {
  return integer(GL_SUBPIXEL_BITS);
}

Preview::Preview(bool wanted) {
  is_preview = wanted && subpixel_bits() < kEnoughSubpixelBits;
  ProgramCache::variant = is_preview ? "\npreview" : "";
}
Preview::~Preview() {
  is_preview = false;
  ProgramCache::variant.clear();
}
Target::Kind Preview::kind() {
  return is_preview ? Target::Kind::encoded : Target::Kind::color;
}

void set_shader_text(GLuint shader, const GLchar* text) {
  GLint stage = 0;
  (glGetShaderiv)(shader, GL_SHADER_TYPE, &stage);
  const std::string es = es_source(text, stage == GL_FRAGMENT_SHADER,
                                   is_preview ? kEnoughSubpixelBits : subpixel_bits(), is_preview);
  const char* data = es.c_str();
  (glShaderSource)(shader, 1, &data, nullptr);
}

void get_of_shader(GLuint shader, GLenum name, GLint* value) {
  (glGetShaderiv)(shader, name, value);
  if (name == GL_INFO_LOG_LENGTH) *value = static_cast<GLint>(message_of(shader, *value).size()) + 1;
}

void get_shader_log(GLuint shader, GLsizei size, GLchar* log) {
  GLint length = 0;
  (glGetShaderiv)(shader, GL_INFO_LOG_LENGTH, &length);
  log[message_of(shader, length).copy(log, static_cast<std::size_t>(size) - 1)] = '\0';
}

void set_clear_color(GLfloat red, GLfloat green, GLfloat blue, GLfloat alpha) {
  const auto stored = [](float light) { return is_preview ? image::srgb_from_linear(light) : light; };
  (glClearColor)(stored(red), stored(green), stored(blue), alpha);
}

void set_shift(float x, float y) {
  shift_x = x, shift_y = y;
}

void set_viewport(GLint x, GLint y, GLsizei width_, GLsizei height_) {
  (glViewport)(x, y, width_, height_);
  width = width_, height = height_;
}

void upload_image(GLenum target, GLint level, GLint internal, GLsizei columns, GLsizei rows, GLint border,
                  GLenum format, GLenum type, const void* data) {
  const bool as_floats = reads_floats_better(internal);
  if ((!as_floats && internal != GL_SRGB8) || data == nullptr) {
    (glTexImage2D)(target, level, internal, columns, rows, border, format, type, data);
    return;
  }
  const auto width = static_cast<std::size_t>(columns), height = static_cast<std::size_t>(rows),
             unit = static_cast<std::size_t>(integer(GL_UNPACK_ALIGNMENT)),
             stride = (3 * width + unit - 1) / unit * unit;
  const auto* bytes = static_cast<const unsigned char*>(data);
  /// With an alpha: of three samples OpenGL ES makes no mipmaps.
  const auto with_alpha = [&]<class Sample>(const std::array<Sample, 256>& stored, Sample alpha) {
    std::vector<Sample> samples(4 * width * height, alpha);
    for (std::size_t y = 0, to = 0; y < height; ++y)
      for (std::size_t x = 0; x < width; ++x, to += 4)
        for (std::size_t c = 0; c < 3; ++c) samples[to + c] = stored[bytes[y * stride + 3 * x + c]];
    return samples;
  };
  if (as_floats) {
    const auto encoding = internal == GL_SRGB8 ? image::Encoding::srgb : image::Encoding::linear;
    std::array<float, 256> stored{};
    for (std::size_t i = 0; i < stored.size(); ++i)
      stored[i] = image::from_encoding8(static_cast<std::uint8_t>(i), encoding);
    (glTexImage2D)(target, level, GL_RGBA32F, columns, rows, border, GL_RGBA, GL_FLOAT,
                   with_alpha(stored, 1.0F).data());
  } else {
    std::array<std::uint8_t, 256> stored{};
    std::iota(stored.begin(), stored.end(), std::uint8_t{0});
    (glTexImage2D)(target, level, GL_SRGB8_ALPHA8, columns, rows, border, GL_RGBA, type,
                   with_alpha(stored, std::uint8_t{255}).data());
  }
}

Context::Context(Shaders) {}

std::string Context::renderer() const {
  return renderer_name();
}
std::string Context::version() const {
  return reinterpret_cast<const char*>(glGetString(GL_VERSION));
}
std::string Context::name() const {
  return renderer() + ", " + version();
}

std::vector<std::string> Context::take_errors() {
  constexpr GLenum lost = 0x9242;  // CONTEXT_LOST_WEBGL: the worker is told of it by an event
  while (const GLenum code = glGetError())
    if (code != lost) errors_.push_back(fmt::format("OpenGL error 0x{:04x}", code));
  return std::exchange(errors_, {});
}

std::unique_ptr<Context> create_headless(Shaders, std::string) {
  return std::make_unique<WebContext>();
}

}  // namespace texel::gl
