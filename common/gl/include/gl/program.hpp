// SPDX-License-Identifier: MIT
#pragma once
#include <glad/gl.h>

#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/error.hpp"
#include "gl/shader_source.hpp"

namespace texel::gl {

/// The vertex attributes that shaders may read; attribute i of this list has location i in every program.
inline constexpr const char* kAttributeNames[] = {"position", "normal",    "texcoord",
                                                  "tangent",  "bitangent", "color"};
enum class Attribute { position, normal, texcoord, tangent, bitangent, color };

/// What a page's context adds to programs, and sets, begins so.
inline constexpr const char* kAddedUniforms = "texel_";

/// An active uniform of a linked program.
struct Uniform {
  std::string name;
  GLenum type = 0;
  GLint location = -1;
  bool is_set = false;
};

/// A linked vertex and fragment shader. Errors name the real file and line.
class Program {
 public:
  /// Throws Error (exit 3) with the compiler's messages.
  Program(std::shared_ptr<const ShaderSource> vertex, std::shared_ptr<const ShaderSource> fragment,
          const std::vector<Define>& defines);
  ~Program() { glDeleteProgram(id_); }
  Program& operator=(Program&&) = delete;

  [[nodiscard]] GLuint id() const { return id_; }
  void use() const { glUseProgram(id_); }
  /// As if no uniform had been set: what one picture sets does not help the next. Puts it in use.
  void forget_uniforms();

  /// Sets a uniform of the program, which must be in use. A name that its source does not mention throws
  /// Error. One that this variant does not read is ignored. A sampler is set to the number of its texture
  /// unit: an unsigned number, such as GL_TEXTURE0 or a texture's name, throws Error.
  void set(std::string_view name, int value);
  void set(std::string_view name, GLuint value);
  void set(std::string_view name, float value) { set_floats(name, GL_FLOAT, &value); }
  void set(std::string_view name, const glm::vec2& value) { set_floats(name, GL_FLOAT_VEC2, &value[0]); }
  void set(std::string_view name, const glm::vec3& value) { set_floats(name, GL_FLOAT_VEC3, &value[0]); }
  void set(std::string_view name, const glm::vec4& value) { set_floats(name, GL_FLOAT_VEC4, &value[0]); }
  void set(std::string_view name, const glm::mat3& value) { set_floats(name, GL_FLOAT_MAT3, &value[0][0]); }
  void set(std::string_view name, const glm::mat4& value) { set_floats(name, GL_FLOAT_MAT4, &value[0][0]); }

  [[nodiscard]] const Uniform* find(std::string_view name) const;
  /// Which attributes this variant reads.
  [[nodiscard]] const std::vector<Attribute>& attributes() const { return attributes_; }
  /// Throws Error when a uniform that the program reads was not set since they were forgotten.
  void check_uniforms() const;
  /// "05_normal_map/normal_map.frag"
  [[nodiscard]] std::string name() const;
  /// Its file in the tree, "shaders/05_normal_map/normal_map.frag", for messages.
  [[nodiscard]] Place place() const { return {"shaders/" + name()}; }
  [[nodiscard]] const ShaderSource& vertex() const { return *vertex_; }
  [[nodiscard]] const ShaderSource& fragment() const { return *fragment_; }

 private:
  Program() = default;  // when the rest of the other constructor fails, the destructor deletes it
  void set_floats(std::string_view name, GLenum type, const float* values);
  Uniform* to_set(std::string_view name, std::initializer_list<GLenum> types);
  [[nodiscard]] Error no_unit(std::string_view name, const std::string& value) const;
  std::shared_ptr<const ShaderSource> vertex_, fragment_;
  GLuint id_ = glCreateProgram();
  std::vector<Uniform> uniforms_;
  std::vector<Attribute> attributes_;
};

/// Compiles each program once. A variant is identified by its files and by the defines that they mention.
/// Fast enough for every frame.
class ProgramCache {
 public:
  explicit ProgramCache(std::filesystem::path shader_root);

  /// By what else than its files and defines a program is told from another one: a page sets it.
  static inline std::string variant;

  Program& get(const std::string& vertex, const std::string& fragment,
               const std::vector<Define>& defines = {});
  /// All that were compiled, by the defines that their sources mention.
  [[nodiscard]] const std::map<std::string, std::unique_ptr<Program>>& programs() const { return programs_; }
  /// Forgets everything, so that edited files are read again.
  void clear();
  /// For a watcher: every file that was read, and the folders in which files are searched.
  [[nodiscard]] std::vector<std::filesystem::path> files() const;

 private:
  std::shared_ptr<const ShaderSource> source(const std::string& file);
  std::filesystem::path root_;
  std::map<std::string, std::shared_ptr<const ShaderSource>> sources_;
  std::map<std::string, std::unique_ptr<Program>> programs_;
  std::unordered_map<std::string, Program*> by_request_;  ///< by all defines
  std::vector<std::filesystem::path> tried_;              ///< where sources were looked for
};

}  // namespace texel::gl
