#version 330 core
// SPDX-License-Identifier: MIT
// The colour of a mirror or glass ball: its surroundings, in the directions of reflected and refracted light.
#include "environment.glsl"
#include "rays.glsl"
#include "surface_normal.glsl"
#include "lib/picture.glsl"

#if EVALUATE == EVALUATE_VERTEX
in vec3 vertex_normal;
in vec3 vertex_reflected;
in vec3 vertex_refracted;
in float vertex_reflectance;
#else
in vec3 world_position;
in vec3 world_normal;
#endif

void main() {
#if EVALUATE == EVALUATE_VERTEX
  vec3 normal = vertex_normal;
  Rays rays = Rays(vertex_reflected, vertex_refracted, vertex_reflectance);
#else
  vec3 normal = surface_normal(world_position, world_normal);
  Rays rays = follow_rays(world_position, normal);
#endif
#if VIEW == VIEW_NORMAL
  picture = vec4(normalize(normal), 1.0);
#elif VIEW == VIEW_DIRECTION
#if SURFACE == SURFACE_REFRACTION
  picture = vec4(normalize(rays.reflectance > 0.5 ? rays.reflected : rays.refracted), 1.0);
#else
  picture = vec4(normalize(rays.reflected), 1.0);
#endif
#elif SURFACE == SURFACE_MIRROR
  show(vec4(environment(rays.reflected), 1.0));
#else
  show(vec4(mix(environment(rays.refracted), environment(rays.reflected), rays.reflectance), 1.0));
#endif
}
