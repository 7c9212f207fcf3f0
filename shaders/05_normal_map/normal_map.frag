#version 330 core
// SPDX-License-Identifier: MIT
// Lights the surface with the map's normal, in the surface's frame at this pixel.
in vec3 world_position;
in vec3 world_normal;
in vec2 fragment_texcoord;

uniform sampler2D color_map;
uniform sampler2D normal_map;
uniform mat4 world_from_object;
uniform vec3 eye;    // world space
uniform vec3 light;  // world space, unit vector towards the light
uniform float bump_strength;
uniform float ambient;
uniform float specular;

#include "decode_normal.glsl"
#include "tangent_frame.glsl"
#include "lib/bounded_texcoord.glsl"
#include "lib/light.glsl"
#include "lib/picture.glsl"

// The unit normal of this pixel in world space.
vec3 shading_normal() {
#if !NORMAL_MAPPING || METHOD == METHOD_PER_VERTEX
  return normalize(world_normal);  // per vertex: the map's normals are already in the buffer
#else
  vec3 n = decode_normal(texture(normal_map, bounded_texcoord(fragment_texcoord)).rgb);
  n.xy *= bump_strength;
#if METHOD == METHOD_RAW
  return normalize(n);
#else
  return normalize(tangent_frame() * n);
#endif
#endif
}

void main() {
#if VIEW == VIEW_NORMAL
  picture = vec4(shading_normal(), 1.0);
#elif VIEW == VIEW_TANGENT
  picture = vec4(normalize(tangent_frame()[0]), 1.0);
#elif VIEW == VIEW_TEXCOORD
  picture = vec4(fragment_texcoord, 0.0, 1.0);
#else
  vec3 albedo = texture(color_map, bounded_texcoord(fragment_texcoord)).rgb;
  vec3 normal = shading_normal();
#if NORMAL_MAPPING && METHOD == METHOD_SCREEN_AXES
  show(vec4(albedo * dot(light, normal), 1.0));  // as the report has it: negative light is not cut off
#else
  show(vec4(lit(albedo, normal, normalize(eye - world_position)), 1.0));
#endif
#endif
}
