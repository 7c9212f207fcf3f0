// SPDX-License-Identifier: MIT
// The level of detail that a texture of `size` texels is read at: log2 of the longer side of the pixel's footprint
// in texels (OpenGL 3.3 specification, section 3.8.11, with the longer of the two gradients). Negative: magnified.
float level_of_detail(vec2 texcoord, vec2 size) {
  vec2 dx = dFdx(texcoord) * size, dy = dFdy(texcoord) * size;
  return 0.5 * log2(max(dot(dx, dx), dot(dy, dy)));
}
