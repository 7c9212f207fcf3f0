#version 330 core
// SPDX-License-Identifier: MIT
// A matcap: the surroundings hang on the camera, not on the world. All that
// is looked up is the normal, as the camera sees it. It costs one lookup.
// P.-P. Sloan et al., "The Lit Sphere: A Model for Capturing NPR Shading
// from Art", Graphics Interface 2001.
// Try: orbit. The world turns, and the ball's reflection stays. Then take
// `normal` in place of `seen`, and back in place of (0, 0, -1).
#include "environment.glsl"
#include "rays.glsl"
#include "surface_normal.glsl"
#include "lib/picture.glsl"

#if EVALUATE == EVALUATE_VERTEX
in vec3 vertex_normal;
#else
in vec3 world_position;
in vec3 world_normal;
#endif

void main() {
#if EVALUATE == EVALUATE_VERTEX
  vec3 normal = normalize(vertex_normal);
#else
  vec3 normal = normalize(surface_normal(world_position, world_normal));
#endif
  // The camera's axes in world space; it looks at the ball's middle.
  vec3 back = normalize(eye), right = normalize(cross(vec3(0.0, 1.0, 0.0), back));
  mat3 camera = mat3(right, cross(back, right), back);
  vec3 seen = normal * camera;  // a vector before a matrix: by its transpose
  vec3 direction = reflect(vec3(0.0, 0.0, -1.0), seen);
#if VIEW == VIEW_NORMAL
  picture = vec4(normal, 1.0);
#elif VIEW == VIEW_DIRECTION
  picture = vec4(direction, 1.0);
#else
  show(vec4(environment(direction), 1.0));
#endif
}
