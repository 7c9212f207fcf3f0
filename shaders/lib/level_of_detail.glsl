// SPDX-License-Identifier: MIT
// The level of detail for a pixel whose footprint has the sides dx and dy in texels: log2 of the longer one (OpenGL 3.3
// specification, section 3.8.11, with the longer of the two gradients). Negative: magnified; -50 where nothing changes
// from pixel to pixel, as with coordinates so large that a float cannot tell neighbours apart.
float level_of_gradients(vec2 dx, vec2 dy) {
  return 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), exp2(-100.0)));
}

// The level of detail that a texture of `size` texels is read at.
float level_of_detail(vec2 texcoord, vec2 size) {
  return level_of_gradients(dFdx(texcoord) * size, dFdy(texcoord) * size);
}
