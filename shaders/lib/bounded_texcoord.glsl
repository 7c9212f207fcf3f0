// SPDX-License-Identifier: MIT
// Where a texture is read, whatever the triangle is like. Corners that lie nearly on one line of the screen let a
// coordinate change from pixel to pixel by any amount, infinity and NaN too, and Mesa's anisotropic filter, which
// walks over all texels in between, would not come to an end. Over so many repeats of a picture only its mean is
// left, which one repeat for each pixel reads too: it is the last mipmap. Up to 32 repeats nothing is changed.
vec2 bounded_texcoord(vec2 texcoord) {
  vec4 change = abs(vec4(dFdx(texcoord), dFdy(texcoord)));
  float lost = all(lessThan(change, vec4(32.0))) ? 0.0 : 1.0;  // NaN is less than nothing
  // The four pixels whose differences the filter takes must agree: first the neighbours hear of it, then theirs.
  lost += fwidth(lost);
  lost += fwidth(lost);
  vec2 one_apart = mod(floor(gl_FragCoord.xy), 2.0);  // from pixel to pixel
  if (lost > 0.0) return one_apart;
  // Where all corners have one coordinate, as models with a palette have it, the filter of Mesa 25 and 26 divides
  // 0 by 0. A millionth, and two of the last places of a large coordinate, give it a footprint far below a texel.
  bool same_along_a_line = change.xy == vec2(0.0) || change.zw == vec2(0.0);
  return same_along_a_line ? texcoord + one_apart * (1e-6 + abs(texcoord) * exp2(-22.0)) : texcoord;
}
