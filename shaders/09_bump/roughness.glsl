// SPDX-License-Identifier: MIT
// A pixel that covers many bumps sees a rough mirror. Mipmaps average the bumps' normals: the more these differ, the
// shorter the average. Its length gives the roughness: M. Toksvig, "Mipmapping Normal Maps", JGT 10 (2005).
#include "lib/cube_coordinates.glsl"

// What the mirror shows around `direction`. color: the normal map's colour.
vec4 rough_reflection(samplerCube cube_map, vec3 direction, vec3 color) {
  float len = length(2.0 * color - 1.0);
  // In 8 bits even a constant unit normal is up to 0.005 too short.
  float variance = max(1.0 - len - 0.005, 0.0) / max(len, 0.01);
  // The strength multiplies the slopes and their deviation. Reflection doubles the angle; half a face is 1 radian.
  float deviation = bump_strength * sqrt(variance);
  float size = float(textureSize(cube_map, 0).x);
  float rough_level = log2(max(2.0 * deviation * 0.5 * size, 1.0));
  return textureLod(cube_map, direction, max(rough_level, cube_level_of_detail(direction, size)));
}
