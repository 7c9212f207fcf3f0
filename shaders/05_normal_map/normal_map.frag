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
#include "lib/with_length.glsl"

// The surface's own unit normal at this pixel; +z where the interpolated one has no length.
vec3 own_normal() { return normalize(with_length(world_normal, vec3(0.0, 0.0, 1.0))); }

// Any right-handed frame around the unit vector n.
mat3 any_frame(vec3 n) {
  vec3 T = normalize(cross(abs(n.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), n));
  return mat3(T, cross(n, T), n);
}

// The frame at this pixel; any one where the model's normal and tangent there make none.
mat3 frame_at_pixel() {
  mat3 frame = tangent_frame();
  vec3 across = world_normal;
#if STORED_TANGENT
  across = cross(world_normal, world_tangent.xyz);
#elif STORED_BITANGENT
  across *= length(world_tangent.xyz) * length(world_bitangent);
#elif NORMAL_MAPPING && METHOD == METHOD_SCREEN_AXES
  if (cross(dFdx(world_position), dFdy(world_position)) == vec3(0.0)) across = vec3(0.0);
#endif
  return with_length(across, vec3(0.0)) == vec3(0.0) ? any_frame(own_normal()) : frame;
}

// The unit normal of this pixel in world space.
vec3 shading_normal() {
#if !NORMAL_MAPPING || METHOD == METHOD_PER_VERTEX
  return own_normal();  // per vertex: the map's normals are already in the buffer
#else
  vec3 n = decode_normal(texture(normal_map, bounded_texcoord(fragment_texcoord)).rgb);
  n.xy *= bump_strength;
  n = with_length(n, vec3(0.0, 0.0, 1.0));  // grey is no direction
#if METHOD == METHOD_RAW
  return normalize(n);
#else
  return normalize(with_length(frame_at_pixel() * n, own_normal()));
#endif
#endif
}

void main() {
#if VIEW == VIEW_NORMAL
  picture = vec4(shading_normal(), 1.0);
#elif VIEW == VIEW_TANGENT
  mat3 frame = frame_at_pixel();
  picture = vec4(normalize(with_length(frame[0], any_frame(own_normal())[0])), 1.0);
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
