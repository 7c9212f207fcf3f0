// SPDX-License-Identifier: MIT
// Steps 1.3 and 1.6. The colour of a pixel: the texture's colour at the interpolated coordinate. The sampler filters;
// only supersampling is done here.

// One sample.
vec4 look_up(sampler2D color_map, vec2 texcoord) {
  //@step 1.3 begin
  return texture(color_map, texcoord);
  //@starter
  // return vec4(fract(texcoord), 0.5, 1.0);  // the coordinate as a colour
  //@end
}

// Four samples in the middles of the pixel's quarters. Each covers half the width and takes half the gradient.
vec4 look_up_four(sampler2D color_map, vec2 texcoord) {
  //@step 1.6 begin
  vec2 dx = dFdx(texcoord), dy = dFdy(texcoord);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    vec2 quarter = vec2(i % 2, i / 2) * 0.5 - 0.25;
    sum += textureGrad(color_map, texcoord + quarter.x * dx + quarter.y * dy, 0.5 * dx, 0.5 * dy);
  }
  return 0.25 * sum;
  //@starter
  // return look_up(color_map, texcoord);
  //@end
}

vec4 sample_color(sampler2D color_map, vec2 texcoord) {
#if METHOD == METHOD_SUPERSAMPLED
  return look_up_four(color_map, texcoord);
#else
  return look_up(color_map, texcoord);
#endif
}
