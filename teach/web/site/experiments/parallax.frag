#version 330 core
// SPDX-License-Identifier: MIT
// Parallax by steps: the ray from the eye goes on below the surface,
// until it meets a height field. Bricks then hide the mortar behind them,
// and slide over it as you orbit. It takes the frame of steps 5.5 and 5.6:
// write these first. Bright is deep here, as mortar is.
// T. Kaneko et al., "Detailed Shape Representation with Parallax Mapping",
// ICAT 2001; by steps: N. Tatarchuk, I3D 2006.
// Try: kSteps 4, kDepth 0.2, a flat angle, dx and dy without the 4.
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

#include "tangent_frame.glsl"
#include "lib/light.glsl"
#include "lib/picture.glsl"

const int kSteps = 32;
const float kDepth = 0.05;  // in widths of the texture

// How deep it is there: 0 at the surface, 1 at most. A loop has no
// derivatives of its own: it gets the pixel's.
float depth_at(vec2 st, vec2 dx, vec2 dy) {
  return dot(textureGrad(color_map, st, dx, dy).rgb, vec3(0.2126, 0.7152, 0.0722));
}

// Where the ray meets the height field. to_eye: in the surface's frame.
vec2 met(vec2 st, vec3 to_eye) {
  vec2 dx = 4.0 * dFdx(st), dy = 4.0 * dFdy(st);  // a coarser level: smooth heights
  vec2 by = -kDepth / float(kSteps) * to_eye.xy / max(to_eye.z, 0.15);
  float ray = 0.0, before = 0.0, below = depth_at(st, dx, dy);
  for (int i = 0; i < kSteps && ray < below; ++i) {
    before = below - ray;
    ray += 1.0 / float(kSteps);
    st += by;
    below = depth_at(st, dx, dy);
  }
  float behind = ray - below;  // between the last two places both are straight
  return st - by * (behind / max(behind + before, 1e-6));
}

void main() {
  mat3 frame = tangent_frame();
  vec3 to_eye = normalize(eye - world_position);
  vec2 st = met(fragment_texcoord, to_eye * frame);  // by the transpose
  vec3 n = 2.0 * texture(normal_map, st).rgb - 1.0;
  vec3 normal = normalize(frame * vec3(bump_strength * n.xy, n.z));
#if VIEW == VIEW_TEXCOORD
  picture = vec4(st, 0.0, 1.0);
#elif VIEW == VIEW_NORMAL
  picture = vec4(normal, 1.0);
#elif VIEW == VIEW_TANGENT
  picture = vec4(frame[0], 1.0);
#else
  show(vec4(lit(texture(color_map, st).rgb, normal, to_eye), 1.0));
#endif
}
