// SPDX-License-Identifier: MIT
// Where a pixel reads the picture on the sphere, and how large an area. The area decides the mipmap level. At the back
// of the sphere u jumps from -1/2 to 1/2: there neighbours seem to be a whole picture apart.
#include "sphere_texcoord.glsl"
#include "lib/sphere_differences.glsl"

struct Footprint {
  vec2 texcoord;
  vec2 dx, dy;  // how texcoord changes to the next pixel on the right and above
};

// Step 6.4.
Footprint sphere_footprint(vec3 n) {
  vec2 texcoord = sphere_texcoord(n);
  //@step 6.4 begin
#if SEAM_METHOD == SEAM_METHOD_SELECT
  // The same place counted from 0 to 1 jumps in front. Take it only where it clearly changes less:
  // elsewhere rounding would decide, and neighbours would differ by 1.
  // M. Tarini, "Cylindrical and Toroidal Parameterizations Without Vertex Seams", JGT 16 (2012).
  float other = fract(texcoord.x);
  if (fwidth(other) < fwidth(texcoord.x) - 0.001) texcoord.x = other;
#endif
#if SEAM_METHOD == SEAM_METHOD_ANALYTIC
  return Footprint(texcoord, sphere_gradient(n, dFdx(n)), sphere_gradient(n, dFdy(n)));
#elif SEAM_METHOD == SEAM_METHOD_WRAPPED
  return Footprint(texcoord, wrapped_difference(dFdx(texcoord)), wrapped_difference(dFdy(texcoord)));
#else
  return Footprint(texcoord, dFdx(texcoord), dFdy(texcoord));
#endif
  //@starter
  // return Footprint(texcoord, dFdx(texcoord), dFdy(texcoord));
  //@end
}

vec4 sample_sphere(sampler2D color_map, Footprint footprint) {
#if SEAM_METHOD == SEAM_METHOD_NAIVE || SEAM_METHOD == SEAM_METHOD_SELECT
  return texture(color_map, footprint.texcoord);  // takes the differences itself
#else
  return textureGrad(color_map, footprint.texcoord, footprint.dx, footprint.dy);
#endif
}
