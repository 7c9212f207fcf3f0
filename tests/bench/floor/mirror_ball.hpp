// SPDX-License-Identifier: MIT
// Lab 9's default picture with plain OpenGL. Whoever includes it has made a context and bound the cube map to
// unit 0 and the normal map to unit 1.
#pragma once
#include <numbers>

#include "floor.hpp"

namespace bare {

namespace mirror_ball {

inline constexpr const char* kVertex = R"(#version 330 core
in vec3 position;
uniform mat4 clip_from_world;
out vec3 object_normal;
out vec3 world_position;
void main() {
  object_normal = position;  // the unit ball's, and it is not turned
  world_position = position;
  gl_Position = clip_from_world * vec4(position, 1.0);
})";

inline constexpr const char* kFragment = R"(#version 330 core
in vec3 object_normal;
in vec3 world_position;
uniform samplerCube cube_map;
uniform sampler2D normal_map;
uniform vec3 eye;
const float PI = 3.14159265358979, repeats = 2.0, bump_strength = 0.4;
out vec4 picture;
vec2 wrapped_difference(vec2 d) {
  return vec2(d.x - round(d.x), d.y);
}
void main() {
  vec3 n = normalize(object_normal);
  float u = atan(n.x, n.z) / (-2.0 * PI);
  float v = atan(sqrt(n.x * n.x + n.z * n.z), n.y) / PI;
  vec2 texcoord = vec2(u, v) * repeats, once = texcoord / repeats;
  vec2 dx = wrapped_difference(dFdx(once)), dy = wrapped_difference(dFdy(once));
  vec3 color = textureGrad(normal_map, texcoord, dx * repeats, dy * repeats).rgb;
  vec3 m = (2.0 * color - 1.0) * vec3(bump_strength, bump_strength, 1.0);
  float radius = length(n.xz);
  vec3 T = radius > 1e-16 ? vec3(-n.z, 0.0, n.x) / radius : vec3(-1.0, 0.0, 0.0);
  vec3 normal = normalize(mat3(T, cross(n, T), n) * m);
  picture = vec4(texture(cube_map, reflect(world_position - eye, normal)).rgb, 1.0);
})";

inline constexpr const char* kBackgroundVertex = R"(#version 330 core
in vec3 position;
uniform mat3 world_from_view;
uniform float field_of_view;
out vec3 direction;
void main() {
  float half_height = tan(0.5 * field_of_view);
  direction = world_from_view * vec3(position.xy * half_height, -1.0);
  gl_Position = vec4(position.xy, 1.0, 1.0);
})";

inline constexpr const char* kBackgroundFragment = R"(#version 330 core
in vec3 direction;
uniform samplerCube cube_map;
out vec4 picture;
void main() {
  picture = vec4(texture(cube_map, direction).rgb, 1.0);
})";

/// A unit ball of 64 bands of 128 squares, with a point of its own above and below each outermost square.
struct Ball {
  std::vector<float> positions;
  std::vector<GLuint> indices;

  Ball() {
    constexpr int rings = 64, segments = 128;
    for (int j = 1; j < rings; ++j)
      for (int i = 0; i <= segments; ++i) add(i % segments / double{segments}, j / double{rings});
    const auto south = static_cast<GLuint>(positions.size() / 3);
    for (const int end : {0, 1})
      for (int i = 0; i < segments; ++i) add((i + 0.5) / segments, end);
    const GLuint width = segments + 1, last = (rings - 2) * width;
    for (GLuint i = 0; i < segments; ++i) indices.insert(indices.end(), {south + i, i + 1, i});
    for (GLuint j = 0; j < rings - 2; ++j)
      for (GLuint i = 0; i < segments; ++i) {
        const GLuint a = j * width + i;
        indices.insert(indices.end(), {a, a + 1, a + 1 + width, a, a + 1 + width, a + width});
      }
    for (GLuint i = 0; i < segments; ++i)
      indices.insert(indices.end(), {last + i, last + i + 1, south + segments + i});
  }

 private:
  void add(double s, double t) {
    const double longitude = 2 * std::numbers::pi * s, latitude = std::numbers::pi * (t - 0.5);
    const double around = t == 0 || t == 1 ? 0 : std::cos(latitude);
    for (const double v : {around * std::sin(longitude), std::sin(latitude), around * std::cos(longitude)})
      positions.push_back(static_cast<float>(v));
  }
};

}  // namespace mirror_ball

class MirrorBall {
 public:
  MirrorBall() {
    const glm::vec3 eye(0, 0, 2.5F);
    program_ = link(mirror_ball::kVertex, mirror_ball::kFragment);
    set(program_, "clip_from_world", clip_from_world(eye, 60));
    set(program_, "eye", eye);
    set(program_, "cube_map", 0);
    set(program_, "normal_map", 1);
    const mirror_ball::Ball ball;
    count_ = static_cast<GLsizei>(ball.indices.size());
    ball_ = new_vertex_array();
    attribute(program_, "position", ball.positions, 3);
    indices(ball.indices);

    background_ = link(mirror_ball::kBackgroundVertex, mirror_ball::kBackgroundFragment);
    const glm::mat4 view_from_world = glm::lookAt(eye, glm::vec3(0), glm::vec3(0, 1, 0));
    set(background_, "world_from_view", glm::transpose(glm::mat3(view_from_world)));
    set(background_, "field_of_view", static_cast<float>(std::numbers::pi / 3));
    set(background_, "cube_map", 0);
    quad_ = new_vertex_array();
    attribute(background_, "position", {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, 3);
    indices({0, 1, 2, 0, 2, 3});
  }

  void draw() const {
    glDepthFunc(GL_LESS);
    glUseProgram(program_);
    glBindVertexArray(ball_);
    glEnable(GL_CULL_FACE);  // as the lab draws the half that is seen
    glDrawElements(GL_TRIANGLES, count_, GL_UNSIGNED_INT, nullptr);
    glDisable(GL_CULL_FACE);
    glDepthFunc(GL_LEQUAL);
    glUseProgram(background_);
    glBindVertexArray(quad_);
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, nullptr);
  }

 private:
  GLuint program_ = 0, ball_ = 0, background_ = 0, quad_ = 0;
  GLsizei count_ = 0;
};

}  // namespace bare
