#version 330 core
// SPDX-License-Identifier: MIT
// Each vertex passes on its one texture coordinate and its one normal.
in vec3 position;
in vec3 normal;
in vec2 texcoord;

uniform mat4 clip_from_world;
uniform mat4 world_from_object;  // a rotation, which turns normals as it turns positions
uniform float texture_scale;

out vec3 world_position;
out vec3 world_normal;
out vec2 fragment_texcoord;

void main() {
  world_position = (world_from_object * vec4(position, 1.0)).xyz;
  world_normal = mat3(world_from_object) * normal;
  fragment_texcoord = texcoord * texture_scale;
  gl_Position = clip_from_world * vec4(world_position, 1.0);
}
