// SPDX-License-Identifier: MIT
// Step 2.3. Combines two colours. `first`: the colour times the first picture. `second`: the second picture with its
// alpha; alpha is 1 where it is opaque.
vec3 combine(vec3 first, vec4 second) {
  //@step 2.3 begin
#if COMBINE == COMBINE_MULTIPLY
  return first * second.rgb;
#elif COMBINE == COMBINE_MIX
  return mix(first, second.rgb, mix_factor);
#elif COMBINE == COMBINE_ADD
  return first + second.rgb;
#elif METHOD == METHOD_PREMULTIPLIED
  // Porter and Duff's "over": the colour was multiplied by its alpha before filtering.
  return second.rgb + (1.0 - second.a) * first;
#else
  return mix(first, second.rgb, second.a);
#endif
  //@starter
  // return 0.5 * (first + second.rgb);  // half of each, whatever is asked for
  //@end
}
