#version 330 core
// SPDX-License-Identifier: MIT
// A sphere with one picture, found by two angles, or with six pictures, found by the direction itself.
#include "look_up.glsl"
#include "seam.glsl"
#include "lib/cube_coordinates.glsl"
#include "lib/picture.glsl"

in vec3 object_normal;
in vec3 world_normal;

uniform sampler2D color_map;
uniform samplerCube cube_map;

void main() {
  // Interpolated normals are too short between the vertices. This does not change the angles, but their derivatives.
  vec3 direction = normalize(object_normal);
#if VIEW == VIEW_NORMAL
  picture = vec4(normalize(world_normal), 1.0);
#elif VIEW == VIEW_DIRECTION
  picture = vec4(direction, 1.0);
#elif MAPPING == MAPPING_CUBE
#if VIEW == VIEW_TEXCOORD
  picture = vec4(cube_texcoord(direction), 0.0, 1.0);
#elif VIEW == VIEW_LOD
  picture = vec4(vec3(cube_level_of_detail(direction, float(textureSize(cube_map, 0).x))), 1.0);
#else
  show(vec4(look_up(cube_map, direction).rgb, 1.0));
#endif
#elif VIEW == VIEW_TEXCOORD
  picture = vec4(sphere_footprint(object_normal).texcoord, 0.0, 1.0);  // does not depend on the length
#else
  Footprint footprint = sphere_footprint(direction);
#if VIEW == VIEW_LOD
  vec2 size = vec2(textureSize(color_map, 0));
  picture = vec4(vec3(level_of_gradients(footprint.dx * size, footprint.dy * size)), 1.0);
#else
  show(vec4(sample_sphere(color_map, footprint).rgb, 1.0));
#endif
#endif
}
