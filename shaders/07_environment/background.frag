#version 330 core
// SPDX-License-Identifier: MIT
// What the camera sees behind all objects: the cube map in the direction of the pixel.
#include "background_depth.glsl"
#include "lib/picture.glsl"

in vec3 direction;

uniform samplerCube cube_map;

void main() {
#if VIEW == VIEW_DIRECTION
  picture = vec4(normalize(direction), 1.0);
#elif VIEW == VIEW_DEPTH
  picture = vec4(vec3(background_distance()), 1.0);
#elif VIEW == VIEW_MASK
  picture = vec4(0.0, 0.0, 0.0, 1.0);
#else
  picture = vec4(texture(cube_map, direction).rgb, 1.0);
#endif
}
