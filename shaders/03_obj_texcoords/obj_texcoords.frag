#version 330 core
// SPDX-License-Identifier: MIT
in vec3 world_position;
in vec3 world_normal;
#if TINT == TINT_VERTICES
in vec3 vertex_tint;
#endif

uniform sampler2D color_map;
uniform vec3 tint;   // the material's or part's colour
uniform vec3 eye;    // world space
uniform vec3 light;  // world space, unit vector towards the light
uniform float ambient;
uniform float specular;

#include "surface_color.glsl"
#include "lib/level_of_detail.glsl"
#include "lib/light.glsl"
#include "lib/picture.glsl"
#include "lib/with_length.glsl"

void main() {
  vec3 normal = normalize(with_length(world_normal, vec3(0.0, 0.0, 1.0)));
#if VIEW == VIEW_NORMAL
  picture = vec4(normal, 1.0);
#elif VIEW == VIEW_TEXCOORD
  picture = vec4(surface_texcoord(), 0.0, 1.0);
#elif VIEW == VIEW_LOD
#if METHOD == METHOD_PER_VERTEX
  picture = vec4(0.0, 0.0, 0.0, 1.0);  // the full picture was read, once for each vertex
#else
  picture = vec4(vec3(level_of_detail(surface_texcoord(), vec2(textureSize(color_map, 0)))), 1.0);
#endif
#else
  vec3 color = tint * surface_color();
#if TINT == TINT_VERTICES
  color = mix(color, vertex_tint, 0.8);
#endif
  show(vec4(lit(color, normal, normalize(eye - world_position)), 1.0));
#endif
}
