// SPDX-License-Identifier: MIT
// u and v of lab 6, for the labs that come after it: they do not depend on what stands in lab 6.
#include "lib/sphere_differences.glsl"
#ifdef SEAM_METHOD
#error this is step 6.1: write it in 06_cube_map/sphere_texcoord.glsl
#endif

// Both angles at once, as fractions of a full and of a half turn. n: any length except zero.
vec2 sphere_texcoord(vec3 n) {
  vec2 across = vec2(n.x, length(n.xz)), along = vec2(n.z, n.y);
  return atan(across, along) / vec2(-2.0 * PI, PI);
}
