// SPDX-License-Identifier: MIT
// The level of detail for a pixel whose footprint has the sides dx and dy in texels: log2 of the longer one (OpenGL 3.3
// specification, section 3.8.11, with the longer of the two gradients). Negative: magnified. -50: nothing changes
// from pixel to pixel, for example if a float cannot tell such large coordinates apart.
float level_of_gradients(vec2 dx, vec2 dy) {
  return 0.5 * log2(max(max(dot(dx, dx), dot(dy, dy)), exp2(-100.0)));
}

// The level of detail at which a texture of `size` texels is read.
float level_of_detail(vec2 texcoord, vec2 size) {
  return level_of_gradients(dFdx(texcoord) * size, dFdy(texcoord) * size);
}
