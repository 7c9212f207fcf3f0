#version 330 core
// SPDX-License-Identifier: MIT
in vec3 world_position;
in vec3 world_normal;
in vec2 fragment_texcoord;

uniform sampler2D color_map;
uniform vec3 eye;    // world space
uniform vec3 light;  // world space, unit vector towards the light
uniform float ambient;
uniform float specular;

#include "lib/bounded_texcoord.glsl"
#include "lib/level_of_detail.glsl"
#include "lib/light.glsl"
#include "lib/picture.glsl"
#include "lib/with_length.glsl"

void main() {
  vec3 normal = normalize(with_length(world_normal, vec3(0.0, 0.0, 1.0)));
#if VIEW == VIEW_NORMAL
  picture = vec4(normal, 1.0);
#elif VIEW == VIEW_TEXCOORD
  picture = vec4(fragment_texcoord, 0.0, 1.0);
#elif VIEW == VIEW_LOD
  picture = vec4(vec3(level_of_detail(fragment_texcoord, vec2(textureSize(color_map, 0)))), 1.0);
#else
  vec3 albedo = texture(color_map, bounded_texcoord(fragment_texcoord)).rgb;
  show(vec4(lit(albedo, normal, normalize(eye - world_position)), 1.0));
#endif
}
