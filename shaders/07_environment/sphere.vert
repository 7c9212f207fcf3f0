#version 330 core
// SPDX-License-Identifier: MIT
// A unit sphere, scaled and moved to its place.
in vec3 position;
in vec3 normal;

uniform mat4 clip_from_world;
uniform vec4 place;  // world space: centre, radius

out vec3 direction;

void main() {
  direction = normal;
  gl_Position = clip_from_world * vec4(place.xyz + place.w * position, 1.0);
}
