// SPDX-License-Identifier: MIT
// A pixel that covers many bumps sees a rough mirror. Their normals, averaged by the mipmaps, are shorter the more they
// differ, which tells how rough it is: M. Toksvig, "Mipmapping Normal Maps", JGT 10 (2005).
#include "lib/cube_coordinates.glsl"

// What the mirror shows around `direction`; color: of the normal map.
vec4 rough_reflection(samplerCube cube_map, vec3 direction, vec3 color) {
  float len = length(2.0 * color - 1.0);
  // Unit normals in 8 bits are up to 0.005 too short without differing from anything.
  float variance = max(1.0 - len - 0.005, 0.0) / max(len, 0.01);
  // The strength multiplies slopes and so their deviation. Reflection doubles the angle; half a face is 1 radian or so.
  float deviation = bump_strength * sqrt(variance);
  float size = float(textureSize(cube_map, 0).x);
  float rough_level = log2(max(2.0 * deviation * 0.5 * size, 1.0));
  return textureLod(cube_map, direction, max(rough_level, cube_level_of_detail(direction, size)));
}
