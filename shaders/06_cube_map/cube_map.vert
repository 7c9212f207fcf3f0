#version 330 core
// SPDX-License-Identifier: MIT
// The texture turns with the sphere: it is looked up with the normal in object space.
in vec3 position;  // on the unit sphere: the normal too

uniform mat4 clip_from_world;
uniform mat4 world_from_object;

out vec3 object_normal;
out vec3 world_normal;

void main() {
  object_normal = position;
  world_normal = mat3(world_from_object) * position;  // a rotation
  gl_Position = clip_from_world * (world_from_object * vec4(position, 1.0));
}
