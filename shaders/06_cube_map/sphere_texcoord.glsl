// SPDX-License-Identifier: MIT
// Texture coordinates of a sphere from a point's direction.
#include "lib/sphere_differences.glsl"

// Step 6.1. Longitude and angle from the north pole, as fractions of a full and of a half turn. n: any length except
// zero. u is 0 at +z, falls past +x to -1/2 at the back, and jumps there to 1/2. v is 0 at +y and 1 at -y.
// The worksheet's formula: u runs left, v down. So a picture with the bottom row first is turned by 180 degrees.
vec2 sphere_texcoord(vec3 n) {
  //@step 6.1 begin
  float u = atan(n.x, n.z) / (-2.0 * PI);
  float v = atan(sqrt(n.x * n.x + n.z * n.z), n.y) / PI;
  return vec2(u, v);
  //@starter
  // return n.xy;
  //@end
}
