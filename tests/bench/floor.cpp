// SPDX-License-Identifier: MIT
// floor ASSETS FILE.png [COUNT]: lab 5's default picture, drawn and saved COUNT times by a program that
// somebody wrote by hand for this picture alone: OSMesa, libspng and a mipmap chain. None of it is the
// course's.
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <spng.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <iterator>
#include <string>
#include <vector>

namespace {

constexpr int kSize = 512;                                 ///< pixels a side of the picture
constexpr int kSamples = 4;                                ///< a pixel
constexpr float kBackground[] = {0.035F, 0.042F, 0.055F};  ///< linear light

void check(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::exit(3);
}

/// A square picture of a power of two; RGB, 8 bits a channel.
struct Picture {
  std::size_t side = 0;
  std::vector<std::uint8_t> samples;
};

/// Bottom row first, as OpenGL has it.
Picture read_png(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::vector<char> bytes(std::istreambuf_iterator<char>(in), {});
  spng_ctx* png = spng_ctx_new(0);
  spng_ihdr header{};
  spng_set_png_buffer(png, bytes.data(), bytes.size());
  check(spng_get_ihdr(png, &header) == 0, path.c_str());
  const std::size_t side = header.width, row = 3 * side;
  Picture picture{side, std::vector<std::uint8_t>(row * side)};
  spng_decode_image(png, nullptr, 0, SPNG_FMT_RGB8, SPNG_DECODE_PROGRESSIVE);
  for (std::size_t y = side; y-- > 0;) spng_decode_row(png, picture.samples.data() + y * row, row);
  spng_ctx_free(png);
  return picture;
}

void write_png(const char* path, const std::vector<std::uint8_t>& rgba) {
  spng_ctx* png = spng_ctx_new(SPNG_CTX_ENCODER);
  std::FILE* file = std::fopen(path, "wb");
  check(file != nullptr, path);
  spng_set_png_file(png, file);
  spng_ihdr header{kSize, kSize, 8, SPNG_COLOR_TYPE_TRUECOLOR, 0, 0, 0};
  spng_set_ihdr(png, &header);
  spng_set_option(png, SPNG_IMG_COMPRESSION_LEVEL, 1);
  spng_set_option(png, SPNG_FILTER_CHOICE, SPNG_FILTER_CHOICE_UP);
  spng_encode_image(png, nullptr, 0, SPNG_FMT_PNG, SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE);
  std::array<std::uint8_t, 3 * kSize> row{};
  for (std::size_t y = kSize; y-- > 0;) {
    for (std::size_t x = 0; x < kSize; ++x)
      for (std::size_t c = 0; c < 3; ++c) row[3 * x + c] = rgba[4 * (y * kSize + x) + c];
    spng_encode_row(png, row.data(), row.size());
  }
  spng_ctx_free(png);
  check(std::fclose(file) == 0, path);
}

enum class Encoding { srgb, linear };

double decode_srgb(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

/// Samples of 8 bits to linear light and back; sRGB by a table of where each sample begins.
class Curve {
 public:
  explicit Curve(Encoding encoding) : encoding_(encoding) {
    const auto decode = [&](double v) { return encoding == Encoding::srgb ? decode_srgb(v) : v; };
    for (std::size_t i = 0; i < 256; ++i) {
      linear_[i] = static_cast<float>(decode(static_cast<double>(i) / 255));
      begins_[i] = decode((static_cast<double>(i) - 0.5) / 255);
    }
    std::size_t sample = 0;
    for (std::size_t cell = 0; cell < low_.size(); ++cell) {
      while (sample < 255 && begins_[sample + 1] <= static_cast<double>(cell) / 4096) ++sample;
      low_[cell] = static_cast<std::uint8_t>(sample);
    }
  }
  [[nodiscard]] float linear(std::uint8_t sample) const { return linear_[sample]; }
  [[nodiscard]] std::uint8_t sample(float linear) const {
    if (encoding_ == Encoding::linear) return static_cast<std::uint8_t>(double{linear} * 255 + 0.5);
    const std::uint8_t low = low_[static_cast<std::size_t>(linear * 4096)];
    return static_cast<std::uint8_t>(low + (low < 255 && double{linear} >= begins_[low + 1U] ? 1 : 0));
  }

 private:
  Encoding encoding_;
  std::array<float, 256> linear_{};
  std::array<double, 256> begins_{};
  std::array<std::uint8_t, 4097> low_{};
};

/// A picture with all its levels, each the mean of four texels in linear light:
/// glGenerateMipmap takes 100 ms to compile for sRGB, and rounds otherwise.
void upload(const Picture& picture, GLint internal, const Curve& curve) {
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  const auto store = [=](GLint level, std::size_t side, const std::vector<std::uint8_t>& samples) {
    const auto size = static_cast<GLsizei>(side);
    glTexImage2D(GL_TEXTURE_2D, level, internal, size, size, 0, GL_RGB, GL_UNSIGNED_BYTE, samples.data());
  };
  store(0, picture.side, picture.samples);
  std::size_t side = picture.side;
  std::vector<float> level(picture.samples.size()), next;
  for (std::size_t i = 0; i < level.size(); ++i) level[i] = curve.linear(picture.samples[i]);
  std::vector<std::uint8_t> stored(level.size() / 4);
  for (GLint number = 1; side > 1; ++number) {
    const std::size_t row = 3 * side;
    side /= 2;
    next.resize(3 * side * side);
    for (std::size_t y = 0; y < side; ++y)
      for (std::size_t x = 0; x < side; ++x)
        for (std::size_t c = 0; c < 3; ++c) {
          const float* in = level.data() + 2 * y * row + 6 * x + c;
          next[3 * (y * side + x) + c] =
              0.5F * (0.5F * in[0] + 0.5F * in[row]) + 0.5F * (0.5F * in[3] + 0.5F * in[row + 3]);
        }
    for (std::size_t i = 0; i < next.size(); ++i) stored[i] = curve.sample(next[i]);
    store(number, side, stored);
    level.swap(next);
  }
}

/// A texture on `unit`, repeated.
void bind_texture(GLenum unit, const std::string& path, Encoding encoding) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glActiveTexture(GL_TEXTURE0 + unit);
  glBindTexture(GL_TEXTURE_2D, texture);
  upload(read_png(path), encoding == Encoding::srgb ? GL_SRGB8 : GL_RGB8, Curve(encoding));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MAX_ANISOTROPY_EXT, 8);
}

GLuint link(const char* vertex, const char* fragment) {
  const GLuint program = glCreateProgram();
  for (const auto& [stage, text] : {std::pair{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}) {
    const GLuint shader = glCreateShader(static_cast<GLenum>(stage));
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  check(linked != 0, "a shader does not compile");
  glUseProgram(program);
  return program;
}

template <class Value>
void buffer_of(GLenum target, const std::vector<Value>& values) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(target, buffer);
  glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(Value)), values.data(), GL_STATIC_DRAW);
}

/// `components` floats a vertex at the location that the program gave the name; nothing where it reads none.
void attribute(GLuint program, const char* name, const std::vector<float>& values, GLint components) {
  buffer_of(GL_ARRAY_BUFFER, values);
  const auto location = static_cast<GLuint>(glGetAttribLocation(program, name));
  glVertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, 0, nullptr);
  glEnableVertexAttribArray(location);
}

/// OSMesa with a multisampled sRGB picture to draw into.
class Canvas {
 public:
  Canvas() {
    setenv("GALLIVM_PERF", "no_aos_sampling", 0);  // exact filtering of 8-bit textures, as in the labs
    const int attributes[] = {OSMESA_FORMAT,
                              OSMESA_RGBA,
                              OSMESA_PROFILE,
                              OSMESA_CORE_PROFILE,
                              OSMESA_CONTEXT_MAJOR_VERSION,
                              3,
                              OSMESA_CONTEXT_MINOR_VERSION,
                              3,
                              0};
    check(OSMesaMakeCurrent(OSMesaCreateContextAttribs(attributes, nullptr), pixel_, GL_UNSIGNED_BYTE, 1,
                            1) != 0,
          "OSMesa gives no context");
    GLuint buffers[3], framebuffers[2];
    glGenRenderbuffers(3, buffers);
    glGenFramebuffers(2, framebuffers);
    resolved_ = framebuffers[0];
    drawn_ = framebuffers[1];
    storage(resolved_, buffers[0], GL_SRGB8_ALPHA8, GL_COLOR_ATTACHMENT0, 0);
    storage(drawn_, buffers[1], GL_SRGB8_ALPHA8, GL_COLOR_ATTACHMENT0, kSamples);
    storage(drawn_, buffers[2], GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, kSamples);
    glViewport(0, 0, kSize, kSize);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_DEPTH_TEST);
    glClearColor(kBackground[0], kBackground[1], kBackground[2], 1);
  }

  void clear() const {
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }

  void save(const char* path) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
    glBlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
    std::vector<std::uint8_t> rgba(std::size_t{4} * kSize * kSize);
    glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    check(glGetError() == GL_NO_ERROR, "OpenGL reports an error");
    write_png(path, rgba);
  }

 private:
  static void storage(GLuint framebuffer, GLuint buffer, GLenum format, GLenum attachment, int samples) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glBindRenderbuffer(GL_RENDERBUFFER, buffer);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, kSize, kSize);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  }

  unsigned char pixel_[4] = {};
  GLuint resolved_ = 0, drawn_ = 0;
};

/// The eye of an orbiting camera, and its projection: as the labs have them, angles in degrees.
glm::vec3 direction(float yaw, float pitch) {
  const float a = glm::radians(yaw), b = glm::radians(pitch);
  return {std::sin(a) * std::cos(b), std::sin(b), std::cos(a) * std::cos(b)};
}
glm::mat4 clip_from_world(const glm::vec3& eye, float degrees) {
  // Of a constant the compiler would take the tangent, and round it otherwise than the library does.
  const volatile float field_of_view = degrees;
  return glm::perspective(glm::radians(field_of_view), 1.0F, 0.05F, 200.0F) *
         glm::lookAt(eye, glm::vec3(0), glm::vec3(0, 1, 0));
}

void set(GLuint program, const char* name, const glm::mat4& value) {
  glUniformMatrix4fv(glGetUniformLocation(program, name), 1, GL_FALSE, glm::value_ptr(value));
}
void set(GLuint program, const char* name, const glm::vec3& value) {
  glUniform3fv(glGetUniformLocation(program, name), 1, glm::value_ptr(value));
}
void set(GLuint program, const char* name, int value) {
  glUniform1i(glGetUniformLocation(program, name), value);
}

constexpr const char* kVertex = R"(#version 330 core
in vec3 position;
in vec3 normal;
in vec2 texcoord;
in vec4 tangent;
uniform mat4 clip_from_world;
out vec3 world_position;
out vec3 world_normal;
out vec2 fragment_texcoord;
out vec4 world_tangent;
void main() {
  world_position = position;
  world_normal = normalize(normal);
  fragment_texcoord = texcoord;
  world_tangent = vec4(normalize(tangent.xyz), tangent.w);
  gl_Position = clip_from_world * vec4(position, 1.0);
})";

constexpr const char* kFragment = R"(#version 330 core
in vec3 world_position;
in vec3 world_normal;
in vec2 fragment_texcoord;
in vec4 world_tangent;
uniform sampler2D color_map;
uniform sampler2D normal_map;
uniform vec3 eye;
uniform vec3 light;
const float ambient = 0.2, specular = 0.2;
out vec4 picture;
vec3 lit(vec3 albedo, vec3 normal, vec3 to_eye) {
  float diffuse = max(dot(normal, light), 0.0);
  float highlight = diffuse > 0.0 ? pow(max(dot(normal, normalize(light + to_eye)), 0.0), 48.0) : 0.0;
  return albedo * mix(ambient, 1.0, diffuse) + specular * highlight;
}
void main() {
  vec3 albedo = texture(color_map, fragment_texcoord).rgb;
  vec3 n = texture(normal_map, fragment_texcoord).rgb * 2.0 - 1.0;
  vec3 T = world_tangent.xyz;
  vec3 N = world_normal;
  vec3 normal = normalize(mat3(T, world_tangent.w * cross(N, T), N) * n);
  picture = vec4(lit(albedo, normal, normalize(eye - world_position)), 1.0);
})";

}  // namespace

int main(int argc, char** argv) {
  check(argc == 3 || argc == 4, "give ASSETS FILE.png [COUNT]");
  const std::string assets = argv[1];
  const Canvas canvas;
  bind_texture(0, assets + "/textures/brick.png", Encoding::srgb);
  bind_texture(1, assets + "/normal_maps/brick.png", Encoding::linear);

  // Six squares; on each the texture's s runs along `right`, which is its tangent.
  const glm::vec3 rights[] = {{1, 0, 0}, {-1, 0, 0}, {0, 0, -1}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}};
  const glm::vec3 ups[] = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}};
  std::vector<float> positions, normals, texcoords, tangents;
  std::vector<GLuint> indices;
  const auto add = [](std::vector<float>& list, const glm::vec3& v) {
    list.insert(list.end(), {v.x, v.y, v.z});
  };
  for (GLuint face = 0; face < 6; ++face) {
    const glm::vec3 right = rights[face], up = ups[face], outward = glm::cross(right, up);
    for (const glm::vec2 st : {glm::vec2(0, 0), {1, 0}, {0, 1}, {1, 1}}) {
      add(positions, 0.577F * (outward + (2 * st.s - 1) * right + (2 * st.t - 1) * up));
      add(normals, outward);
      texcoords.insert(texcoords.end(), {st.s, st.t});
      add(tangents, right);
      tangents.push_back(1);
    }
    for (const GLuint corner : {0, 1, 3, 0, 3, 2}) indices.push_back(4 * face + corner);
  }

  const GLuint program = link(kVertex, kFragment);
  const glm::vec3 eye = 3.0F * direction(32, 24);
  set(program, "clip_from_world", clip_from_world(eye, 45));
  set(program, "eye", eye);
  set(program, "light", direction(70, 35));
  set(program, "color_map", 0);
  set(program, "normal_map", 1);
  GLuint vertex_array = 0;
  glGenVertexArrays(1, &vertex_array);
  glBindVertexArray(vertex_array);
  attribute(program, "position", positions, 3);
  attribute(program, "normal", normals, 3);
  attribute(program, "texcoord", texcoords, 2);
  attribute(program, "tangent", tangents, 4);
  buffer_of(GL_ELEMENT_ARRAY_BUFFER, indices);
  for (int i = 0; i < (argc == 4 ? std::atoi(argv[3]) : 1); ++i) {
    canvas.clear();
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
    canvas.save(argv[2]);
  }
}
