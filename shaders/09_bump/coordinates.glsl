// SPDX-License-Identifier: MIT
// Where the normal map is read for a point of the ball. n: unit normal in object space.
#include "lib/sphere_coordinates.glsl"

uniform sampler2D normal_map;
uniform int repeats;

// Step 9.1. Longitude and latitude as in lab 6; the map repeats `repeats` times along each.
vec2 map_texcoord(vec3 n) {
  //@step 9.1 begin
  return sphere_texcoord(n) * float(repeats);
  //@starter
  // return n.xy * float(repeats);
  //@end
}

// The map's colour there. At the back u jumps: the footprint takes the difference the short way round (lab 6).
vec3 read_map(vec3 n) {
  vec2 texcoord = map_texcoord(n), once = texcoord / float(repeats);
  vec2 dx = wrapped_difference(dFdx(once)), dy = wrapped_difference(dFdy(once));
  return textureGrad(normal_map, texcoord, dx * float(repeats), dy * float(repeats)).rgb;
}
