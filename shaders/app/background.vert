#version 330 core
// SPDX-License-Identifier: MIT
// A quad that fills the picture at the far plane: z = w gives depth 1 for any near and far (lab 7).
#include "lib/view_ray.glsl"

in vec3 position;

out vec3 direction;

void main() {
  direction = view_ray(position.xy);
  gl_Position = vec4(position.xy, 1.0, 1.0);
}
