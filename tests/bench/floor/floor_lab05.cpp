// SPDX-License-Identifier: MIT
// The floor under lab 5: its default picture, written by hand.
#include "floor.hpp"

namespace {

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
  const bare::Arguments arguments(argc, argv);
  const bare::Canvas canvas;
  bare::texture_2d(0, arguments.assets + "/textures/brick.png", bare::Encoding::srgb, 8);
  bare::texture_2d(1, arguments.assets + "/normal_maps/brick.png", bare::Encoding::linear, 8);

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

  const GLuint program = bare::link(kVertex, kFragment);
  const glm::vec3 eye = 3.0F * bare::direction(32, 24);
  bare::set(program, "clip_from_world", bare::clip_from_world(eye, 45));
  bare::set(program, "eye", eye);
  bare::set(program, "light", bare::direction(70, 35));
  bare::set(program, "color_map", 0);
  bare::set(program, "normal_map", 1);
  bare::new_vertex_array();
  bare::attribute(program, "position", positions, 3);
  bare::attribute(program, "normal", normals, 3);
  bare::attribute(program, "texcoord", texcoords, 2);
  bare::attribute(program, "tangent", tangents, 4);
  bare::indices(indices);
  bare::draw_and_save(arguments, canvas, [count = static_cast<GLsizei>(indices.size())] {
    glDrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, nullptr);
  });
}
