// SPDX-License-Identifier: MIT
// A texture coordinate that is safe to read for any triangle. If the corners lie nearly on one line of the screen, a
// coordinate can change between pixels by any amount, even infinity or NaN. Mesa's anisotropic filter walks over
// all texels in between, and would not end. A pixel that covers so many repeats of a picture shows only its mean.
// One repeat per pixel reads that mean too: it is the last mipmap. Up to 32 repeats nothing is changed.
vec2 bounded_texcoord(vec2 texcoord) {
  vec4 change = abs(vec4(dFdx(texcoord), dFdy(texcoord)));
  float lost = all(lessThan(change, vec4(32.0))) ? 0.0 : 1.0;  // NaN is less than nothing
  // The filter takes differences within four pixels, which must agree: after two rounds all four know of a loss.
  lost += fwidth(lost);
  lost += fwidth(lost);
  vec2 one_apart = mod(floor(gl_FragCoord.xy), 2.0);  // from pixel to pixel
  if (lost > 0.0) return one_apart;
  // If all corners have the same coordinate, as in models with a palette, the filter of Mesa 25 and 26 divides
  // 0 by 0. A millionth, and two of the last places of a large coordinate, give it a footprint far below a texel.
  bool same_along_a_line = change.xy == vec2(0.0) || change.zw == vec2(0.0);
  return same_along_a_line ? texcoord + one_apart * (1e-6 + abs(texcoord) * exp2(-22.0)) : texcoord;
}
