// SPDX-License-Identifier: MIT
// Step 9.2. The map's colour, 0 to 1 each, as a normal, -1 to 1 each: x along the tangent, y along the bitangent, z along
// the ball's own normal. The relief adds x and y: multiply these by the strength. Not of unit length.
uniform float bump_strength;

vec3 map_normal(vec3 color) {
  //@step 9.2 begin
  return (2.0 * color - 1.0) * vec3(bump_strength, bump_strength, 1.0);
  //@starter
  // return color * vec3(bump_strength, bump_strength, 1.0);
  //@end
}
