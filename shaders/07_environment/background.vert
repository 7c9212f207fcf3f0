#version 330 core
// SPDX-License-Identifier: MIT
// The quad is already in clip space. Its directions are linear there: interpolating them between the
// corners is exact, if they are not made unit vectors here.
#include "background_depth.glsl"
#include "lib/view_ray.glsl"

in vec3 position;

uniform mat4 direction_from_clip;
uniform vec3 eye;  // world space

out vec3 direction;

void main() {
  vec4 clip = vec4(position.xy, PLANE == PLANE_NEAR ? -1.0 : 1.0, 1.0);
#if METHOD == METHOD_ANALYTIC_RAY
  direction = view_ray(clip.xy);
#elif METHOD == METHOD_UNPROJECT
  vec4 point = direction_from_clip * clip;
  direction = point.xyz / point.w - eye;
#else
  direction = (direction_from_clip * clip).xyz;
#endif
  gl_Position = vec4(position.xy, kBackgroundZ, 1.0);
}
