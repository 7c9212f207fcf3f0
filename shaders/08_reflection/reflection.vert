#version 330 core
// SPDX-License-Identifier: MIT
// Position and normal of each vertex; also the rays, if they are computed per vertex.
in vec3 position;
in vec3 normal;

uniform mat4 clip_from_world;
uniform mat4 world_from_object;
uniform mat3 normal_from_object;

#if EVALUATE == EVALUATE_VERTEX
#include "rays.glsl"

out vec3 vertex_normal;
out vec3 vertex_reflected;
out vec3 vertex_refracted;
out float vertex_reflectance;
#else
out vec3 world_position;
out vec3 world_normal;
#endif

void main() {
  vec3 p = (world_from_object * vec4(position, 1.0)).xyz;
  vec3 n = normalize(normal_from_object * normal);
#if EVALUATE == EVALUATE_VERTEX
  Rays rays = follow_rays(p, n);
  vertex_normal = n;
  vertex_reflected = rays.reflected;
  vertex_refracted = rays.refracted;
  vertex_reflectance = rays.reflectance;
#else
  world_position = p;
  world_normal = n;
#endif
  gl_Position = clip_from_world * vec4(p, 1.0);
}
