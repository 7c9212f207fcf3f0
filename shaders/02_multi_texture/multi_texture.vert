#version 330 core
// SPDX-License-Identifier: MIT
// One texture coordinate for both pictures.
in vec3 position;
in vec2 texcoord;

uniform mat4 clip_from_object;
uniform float texture_scale;

out vec2 fragment_texcoord;

void main() {
  gl_Position = clip_from_object * vec4(position, 1.0);
  fragment_texcoord = texcoord * texture_scale;
}
