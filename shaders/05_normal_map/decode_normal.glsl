// SPDX-License-Identifier: MIT
// Step 5.1. A colour from the normal map, 0 to 1 each, becomes a normal in the tangent frame, -1 to 1 each: red
// along the tangent, green along the bitangent, blue along the surface's normal. Not of unit length after filtering.
vec3 decode_normal(vec3 color) {
  //@step 5.1 begin
#if DECODE == DECODE_EXACT_FLAT
  return (color * 255.0 - 128.0) / 127.0;
#else
  return color * 2.0 - 1.0;
#endif
  //@starter
  // return color;
  //@end
}
