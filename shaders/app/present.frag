#version 330 core
// SPDX-License-Identifier: MIT
// Shows the values of a data view as sRGB colours. NaN is magenta: it must not look like black.
uniform sampler2D values;

out vec4 picture;

const vec3 kBackground = vec3(0.20, 0.22, 0.25);

// image::shown makes the same colours of a file's values.
vec3 color_of(vec3 value) {
#if VIEW == VIEW_TEXCOORD
  return vec3(fract(value.xy), 0.0);
#elif VIEW == VIEW_LOD
  // From dark violet through green to yellow; lightness grows with t.
  float t = clamp(value.x / 9.0, 0.0, 1.0);
  return vec3(0.27 + t * (-0.35 + t * 1.06), 0.02 + t * (1.15 - t * 0.27), 0.33 + t * (0.98 - t * 1.20));
#elif VIEW == VIEW_DEPTH
  return vec3(1.0 / (1.0 + 0.25 * value.x));
#elif VIEW == VIEW_MASK
  return vec3(value.x);
#else  // a direction
  return 0.5 + 0.5 * value;
#endif
}

void main() {
  vec4 value = texelFetch(values, ivec2(gl_FragCoord.xy), 0);
  if (any(isnan(value)) || any(isinf(value))) {
    picture = vec4(1.0, 0.0, 1.0, 1.0);
    return;
  }
  picture = vec4(value.a > 0.0 ? color_of(value.xyz) : kBackground, 1.0);
}
