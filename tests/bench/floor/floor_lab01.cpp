// SPDX-License-Identifier: MIT
// The floor under lab 1: its default picture, written by hand.
#include "floor.hpp"

namespace {

constexpr const char* kVertex = R"(#version 330 core
in vec3 position;
in vec2 texcoord;
uniform mat4 clip_from_object;
out vec2 fragment_texcoord;
void main() {
  gl_Position = clip_from_object * vec4(position, 1.0);
  fragment_texcoord = texcoord;
})";

constexpr const char* kFragment = R"(#version 330 core
in vec2 fragment_texcoord;
uniform sampler2D color_map;
out vec4 picture;
void main() {
  vec2 dx = dFdx(fragment_texcoord), dy = dFdy(fragment_texcoord);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    vec2 quarter = vec2(i % 2, i / 2) * 0.5 - 0.25;
    sum += textureGrad(color_map, fragment_texcoord + quarter.x * dx + quarter.y * dy, 0.5 * dx, 0.5 * dy);
  }
  picture = vec4(0.25 * sum.rgb, 1.0);
})";

}  // namespace

int main(int argc, char** argv) {
  const bare::Arguments arguments(argc, argv);
  const bare::Canvas canvas;
  bare::texture_2d(0, arguments.assets + "/textures/brick.png", bare::Encoding::srgb, 1);

  const GLuint program = bare::link(kVertex, kFragment);
  bare::set(program, "clip_from_object", bare::clip_from_world({0, 0, 2.4142135F}, 45));
  bare::new_vertex_array();
  constexpr float s = 0.7F;
  bare::attribute(program, "position", {-s, -s, 0, s, -s, 0, s, s, 0, -s, s, 0}, 3);
  bare::attribute(program, "texcoord", {0, 0, 1, 0, 1, 1, 0, 1}, 2);
  bare::indices({0, 1, 2, 0, 2, 3});
  bare::draw_and_save(arguments, canvas, [] { glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr); });
}
