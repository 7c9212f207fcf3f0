// SPDX-License-Identifier: MIT
// Which face of a cube map a direction meets, and where, as texture(samplerCube, direction) finds it (OpenGL 3.3
// core specification, section 3.8.10, table 3.17).
#include "lib/level_of_detail.glsl"

// Columns: the directions in which s, t and the distance to the face grow. The largest component selects the face.
mat3 cube_face_axes(vec3 direction) {
  vec3 size = abs(direction);
  vec3 side = mix(vec3(-1.0), vec3(1.0), greaterThanEqual(direction, vec3(0.0)));
  if (size.x >= size.y && size.x >= size.z) return mat3(0.0, 0.0, -side.x, 0.0, -1.0, 0.0, side.x, 0.0, 0.0);
  if (size.y >= size.z) return mat3(1.0, 0.0, 0.0, 0.0, 0.0, side.y, 0.0, side.y, 0.0);
  return mat3(side.z, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, side.z);
}

// s and t on that face, 0 to 1 each; t = 0 is the row that is uploaded first.
vec2 cube_texcoord(vec3 direction) {
  vec3 p = direction * cube_face_axes(direction);  // the components along the three axes
  return 0.5 + 0.5 * p.xy / p.z;
}

// The level of detail of a cube map whose faces have `size` texels a side. The derivative stays on one face:
// there is no jump from face to face.
float cube_level_of_detail(vec3 direction, float size) {
  mat3 axes = cube_face_axes(direction);
  vec3 p = direction * axes, dp_dx = dFdx(direction) * axes, dp_dy = dFdy(direction) * axes;
  vec2 dx = 0.5 * (dp_dx.xy * p.z - p.xy * dp_dx.z) / (p.z * p.z);
  vec2 dy = 0.5 * (dp_dy.xy * p.z - p.xy * dp_dy.z) / (p.z * p.z);
  return level_of_gradients(dx * size, dy * size);
}
