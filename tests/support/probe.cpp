// SPDX-License-Identifier: MIT
#include "probe.hpp"

#include <fmt/format.h>

#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "gl/target.hpp"
#include "gl/upload.hpp"

namespace texel::test {
namespace {

// The table is folded into rows of so many pixels: a single row would be wider than a texture may be.
constexpr int kWidth = 1024;

/// One column as a texture, its last row filled up with zeros.
gl::Texture make_column(const std::vector<glm::vec4>& values, int height) {
  std::vector<glm::vec4> padded = values;
  padded.resize(static_cast<std::size_t>(kWidth) * static_cast<std::size_t>(height), glm::vec4(0));
  gl::Texture texture;
  const gl::ScopedBinding binding(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kWidth, height, 0, GL_RGBA, GL_FLOAT, padded.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

std::string column_name(std::size_t column) {
  return std::string(1, static_cast<char>('a' + column));
}

}  // namespace

std::vector<glm::vec4> probe(const std::filesystem::path& shader_root, const std::string& file,
                             const std::string& expression, const std::vector<gl::Define>& defines,
                             std::span<const std::vector<glm::vec4>> columns) {
  const std::size_t count = columns.empty() ? 0 : columns.front().size();
  if (count == 0) return {};

  std::string fragment = fmt::format("#version 330 core\n#include \"{}\"\nout vec4 result;\n", file);
  for (std::size_t i = 0; i < columns.size(); ++i)
    fragment += fmt::format("uniform sampler2D column_{};\n", column_name(i));
  fragment += "void main() {\n";
  for (std::size_t i = 0; i < columns.size(); ++i)
    fragment +=
        fmt::format("  vec4 {0} = texelFetch(column_{0}, ivec2(gl_FragCoord.xy), 0);\n", column_name(i));
  fragment += fmt::format("  result = {};\n}}\n", expression);

  const auto vertex_source = std::make_shared<const gl::ShaderSource>(shader_root, "app/present.vert");
  const auto fragment_source = std::make_shared<const gl::ShaderSource>(shader_root, "probe", fragment);
  gl::Program program(vertex_source, fragment_source, defines);
  program.use();

  const int height = static_cast<int>((count + kWidth - 1) / kWidth);
  std::vector<gl::Texture> textures;
  for (const std::vector<glm::vec4>& column : columns) textures.push_back(make_column(column, height));
  for (std::size_t i = 0; i < columns.size(); ++i) {
    gl::bind(static_cast<int>(i), GL_TEXTURE_2D, textures[i]);
    program.set("column_" + column_name(i), static_cast<int>(i));
  }
  const gl::Target target(gl::Target::Kind::data, kWidth, height, 1);
  target.bind();
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  const gl::VertexArray no_attributes;
  glBindVertexArray(no_attributes.id());
  glDrawArrays(GL_TRIANGLES, 0, 3);

  const image::ImageF values = target.read_float();
  std::vector<glm::vec4> result(count);
  for (std::size_t i = 0; i < count; ++i)
    result[i] = {values.samples[4 * i], values.samples[4 * i + 1], values.samples[4 * i + 2],
                 values.samples[4 * i + 3]};
  return result;
}

}  // namespace texel::test
