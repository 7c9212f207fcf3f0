#version 330 core
// SPDX-License-Identifier: MIT
in vec2 fragment_texcoord;

uniform sampler2D Tex0;
uniform sampler2D Tex1;
uniform float red, green, blue;
uniform float mix_factor;

#include "combine.glsl"
#include "lib/level_of_detail.glsl"
#include "lib/picture.glsl"

vec3 color() {
  vec3 first = vec3(red, green, blue);
#if UNIT0_ON
  first *= texture(Tex0, fragment_texcoord).rgb;
#endif
#if UNIT1_ON
  return combine(first, texture(Tex1, fragment_texcoord));
#else
  return first;
#endif
}

// The level of the first picture. Two pictures of different size have different levels at a pixel.
float level() {
#if UNIT0_ON
  return level_of_detail(fragment_texcoord, vec2(textureSize(Tex0, 0)));
#elif UNIT1_ON
  return level_of_detail(fragment_texcoord, vec2(textureSize(Tex1, 0)));
#else
  return 0.0;
#endif
}

void main() {
#if VIEW == VIEW_TEXCOORD
  picture = vec4(fragment_texcoord, 0.0, 1.0);
#elif VIEW == VIEW_LOD
  picture = vec4(vec3(level()), 1.0);
#else
  show(vec4(color(), 1.0));
#endif
}
