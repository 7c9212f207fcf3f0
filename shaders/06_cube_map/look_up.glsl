// SPDX-License-Identifier: MIT
// Step 6.2. The colour in a direction: no angles, no seam, no poles. The direction need not have unit length.
vec4 look_up(samplerCube cube_map, vec3 direction) {
  //@step 6.2 begin
  return texture(cube_map, direction);
  //@starter
  // return texture(cube_map, direction.yzx);
  //@end
}
