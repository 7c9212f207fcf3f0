// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "gl/objects.hpp"
#include "gl/program.hpp"
#include "gl/target.hpp"
#include "gl/upload.hpp"

namespace texel::web {

/// Copies a picture into the page's canvas, which has encoded bytes: those of a target of encoded colour, or
/// what the texture of a colour target decodes, encoded again.
class Display {
 public:
  explicit Display(std::filesystem::path shaders) : shaders_(std::move(shaders)) {}
  void show(const gl::Target& picture) {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, picture.width(), picture.height());
    glEnable(GL_FRAMEBUFFER_SRGB);  // the shader encodes: nothing is to be decoded
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    if (picture.kind() == gl::Target::Kind::encoded) {
      picture.bind_for_reading();
      glBlitFramebuffer(0, 0, picture.width(), picture.height(), 0, 0, picture.width(), picture.height(),
                        GL_COLOR_BUFFER_BIT, GL_NEAREST);
      return;
    }
    if (!program_)
      program_.emplace(std::make_shared<const gl::ShaderSource>(shaders_, "app/present.vert"),
                       std::make_shared<const gl::ShaderSource>(shaders_, "display", kFragment),
                       std::vector<gl::Define>());
    program_->use();
    gl::bind(0, GL_TEXTURE_2D, picture.texture());
    program_->set("values", 0);
    glBindVertexArray(no_attributes_.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }

 private:
  static constexpr const char* kFragment = R"(#version 330 core
uniform sampler2D values;
out vec4 shown;
void main() {
  vec3 light = texelFetch(values, ivec2(gl_FragCoord.xy), 0).rgb;
  shown = vec4(mix(light * 12.92, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, greaterThan(light, vec3(0.0031308))), 1.0);
}
)";
  std::filesystem::path shaders_;
  std::optional<gl::Program> program_;  ///< compiled when it is needed
  gl::VertexArray no_attributes_;
};

}  // namespace texel::web
