#version 330 core
// SPDX-License-Identifier: MIT
// Position, texture coordinate and frame of each vertex, in world space.
in vec3 position;
in vec3 normal;
in vec2 texcoord;
#include "vertex_frame.glsl"

uniform mat4 clip_from_world;
uniform mat4 world_from_object;
uniform mat3 normal_from_object;  // object to world space, for normals
uniform float texture_scale;

out vec3 world_position;
out vec3 world_normal;
out vec2 fragment_texcoord;

void main() {
  world_position = (world_from_object * vec4(position, 1.0)).xyz;
  world_normal = normalize(normal_from_object * normal);
  fragment_texcoord = texcoord * texture_scale;
  pass_on_tangents(mat3(world_from_object));
  gl_Position = clip_from_world * vec4(world_position, 1.0);
}
