#version 330 core
// SPDX-License-Identifier: MIT
// A sphere as in lab 6: the cube map in the direction of its normal.
#include "lib/picture.glsl"

in vec3 direction;

uniform samplerCube cube_map;

void main() {
#if VIEW == VIEW_DIRECTION
  picture = vec4(normalize(direction), 1.0);
#else
  show(vec4(texture(cube_map, direction).rgb, 1.0));
#endif
}
