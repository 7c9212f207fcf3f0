// SPDX-License-Identifier: MIT
// The ball's normal at a pixel, in world space. position: on one of the mesh's triangles, world space. interpolated:
// the normal interpolated between the triangle's corners.
#include "rays.glsl"  // for the eye

uniform mat4 object_from_world;
uniform mat3 normal_from_object;

vec3 surface_normal(vec3 position, vec3 interpolated) {
#if NORMAL_METHOD == NORMAL_METHOD_INTERPOLATED
  return interpolated;
#elif NORMAL_METHOD == NORMAL_METHOD_RENORMALISED
  return normalize(interpolated);
#else
  // The triangle lies inside the unit sphere. Follow the view ray, in object space, to where it meets the sphere
  // itself: |p + t d| = 1. From outside take the first of two points, from inside the one ahead.
  vec3 p = (object_from_world * vec4(position, 1.0)).xyz, e = (object_from_world * vec4(eye, 1.0)).xyz;
  vec3 d = normalize(p - e);
  float b = dot(p, d), c = dot(p, p) - 1.0;
  float root = sqrt(max(b * b - c, 0.0));
  return normalize(normal_from_object * (p + (dot(e, e) > 1.0 ? -b - root : -b + root) * d));
#endif
}
