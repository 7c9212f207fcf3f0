#version 330 core
// SPDX-License-Identifier: MIT
// Shows the values of a data view as sRGB colours. NaN is magenta: it must not look like black.
uniform sampler2D values;
uniform int view;  // app::View

out vec4 picture;

const int kNormal = 1, kTangent = 2, kTexcoord = 3, kDirection = 4, kLod = 5, kDepth = 6, kMask = 7;
const vec3 kBackground = vec3(0.20, 0.22, 0.25);

// A colour for t from 0 to 1: from dark violet through green to yellow; lightness grows with t.
vec3 heat(float t) {
  t = clamp(t, 0.0, 1.0);
  return clamp(vec3(0.27 + t * (-0.35 + t * 1.06), 0.02 + t * (1.15 - t * 0.27), 0.33 + t * (0.98 - t * 1.20)), 0.0, 1.0);
}

void main() {
  vec4 value = texelFetch(values, ivec2(gl_FragCoord.xy), 0);
  if (any(isnan(value)) || any(isinf(value))) {
    picture = vec4(1.0, 0.0, 1.0, 1.0);
    return;
  }
  vec3 color = kBackground;
  if (value.a > 0.0) {
    if (view == kNormal || view == kTangent || view == kDirection) color = 0.5 + 0.5 * value.xyz;
    if (view == kTexcoord) color = vec3(fract(value.xy), 0.0);
    if (view == kLod) color = heat(value.x / 9.0);
    if (view == kDepth) color = vec3(1.0 / (1.0 + 0.25 * value.x));
    if (view == kMask) color = vec3(value.x);
  }
  picture = vec4(color, 1.0);
}
