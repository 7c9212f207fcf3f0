// SPDX-License-Identifier: MIT
// Step 1.5. The colour of a pixel: what the texture holds at the interpolated coordinate. The filter is the
// sampler's; only supersampling is done here.
vec4 sample_color(sampler2D color_map, vec2 texcoord) {
//@step 1.5 begin
#if METHOD == METHOD_SUPERSAMPLED
  // Four samples in the middles of the pixel's quarters. Each covers half the width, so it takes half the gradient.
  vec2 dx = dFdx(texcoord), dy = dFdy(texcoord);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    vec2 quarter = vec2(i % 2, i / 2) * 0.5 - 0.25;
    sum += textureGrad(color_map, texcoord + quarter.x * dx + quarter.y * dy, 0.5 * dx, 0.5 * dy);
  }
  return 0.25 * sum;
#else
  return texture(color_map, texcoord);
#endif
//@starter
// return vec4(0.5) + 0.0 * texture(color_map, texcoord);
//@end
}
