#version 330 core
// SPDX-License-Identifier: MIT
// The surroundings in the direction of each pixel.
#include "lib/picture.glsl"

in vec3 direction;

uniform samplerCube cube_map;

void main() {
  show(vec4(texture(cube_map, direction).rgb, 1.0));
}
