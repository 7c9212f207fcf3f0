#version 330 core
// SPDX-License-Identifier: MIT
// A unit sphere, scaled and moved to its place.
in vec3 position;  // on the unit sphere: the normal too

uniform mat4 clip_from_world;
uniform vec4 place;  // world space: centre, radius

out vec3 direction;

void main() {
  direction = position;
  gl_Position = clip_from_world * vec4(place.xyz + place.w * position, 1.0);
}
