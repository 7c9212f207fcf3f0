// SPDX-License-Identifier: MIT
// The surroundings' linear RGB in a direction of any length, from six pictures or from one.
#include "lib/sphere_coordinates.glsl"

uniform samplerCube cube_map;
uniform sampler2D picture_map;

vec3 environment(vec3 direction) {
#if LOOKUP == LOOKUP_CUBE
  return texture(cube_map, direction).rgb;
#elif LOOKUP == LOOKUP_SPHERE_MAP
  // A mirror ball, seen from far away on the +z axis, reflects d where its normal is halfway between d and
  // +z (OpenGL 2.1 specification, section 2.11.4). For d = -z that is the whole rim.
  vec3 d = normalize(direction);
  float m = 2.0 * sqrt(max(dot(d.xy, d.xy) + (d.z + 1.0) * (d.z + 1.0), 1e-12));
  return texture(picture_map, d.xy / m + 0.5).rgb;
#else
  vec2 texcoord = sphere_texcoord(direction);
  vec2 dx = wrapped_difference(dFdx(texcoord)), dy = wrapped_difference(dFdy(texcoord));
  return textureGrad(picture_map, texcoord, dx, dy).rgb;
#endif
}
