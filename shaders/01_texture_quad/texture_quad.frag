#version 330 core
// SPDX-License-Identifier: MIT
#include "sample_color.glsl"
#include "lib/bounded_texcoord.glsl"
#include "lib/level_of_detail.glsl"
#include "lib/picture.glsl"

in vec2 fragment_texcoord;

uniform sampler2D color_map;

void main() {
#if VIEW == VIEW_TEXCOORD
  picture = vec4(fragment_texcoord, 0.0, 1.0);
#elif VIEW == VIEW_LOD
  picture = vec4(vec3(level_of_detail(fragment_texcoord, vec2(textureSize(color_map, 0)))), 1.0);
#elif METHOD == METHOD_ANISOTROPIC
  show(vec4(sample_color(color_map, bounded_texcoord(fragment_texcoord)).rgb, 1.0));
#else
  show(vec4(sample_color(color_map, fragment_texcoord).rgb, 1.0));
#endif
}
