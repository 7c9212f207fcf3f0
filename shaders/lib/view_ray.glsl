// SPDX-License-Identifier: MIT
// The direction in world space in which the camera sees a point of the picture; ndc: -1 to 1 each. Not of unit length,
// but linear in ndc: it may be interpolated. No matrix is inverted, and near and far do not matter.
uniform mat3 world_from_view;
uniform float field_of_view;  // vertical
uniform float aspect;         // width / height

vec3 view_ray(vec2 ndc) {
  float half_height = tan(0.5 * field_of_view);  // at distance 1
  return world_from_view * vec3(ndc * half_height * vec2(aspect, 1.0), -1.0);
}
