#version 330 core
// SPDX-License-Identifier: MIT
// The relief turns with the ball: its frame is built from the normal in object space.
in vec3 position;  // on the unit sphere: the normal too

uniform mat4 clip_from_world;
uniform mat4 world_from_object;

out vec3 object_normal;
out vec3 world_position;

void main() {
  object_normal = position;
  world_position = (world_from_object * vec4(position, 1.0)).xyz;
  gl_Position = clip_from_world * vec4(world_position, 1.0);
}
