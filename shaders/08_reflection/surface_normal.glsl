// SPDX-License-Identifier: MIT
// The normal of the ball in a pixel, in world space. position: on one of the mesh's triangles, world space; interpolated:
// between the normals of its corners.
#include "rays.glsl"  // for the eye

uniform mat4 object_from_world;
uniform mat3 normal_from_object;

vec3 surface_normal(vec3 position, vec3 interpolated) {
#if NORMAL_METHOD == NORMAL_METHOD_INTERPOLATED
  return interpolated;
#elif NORMAL_METHOD == NORMAL_METHOD_RENORMALISED
  return normalize(interpolated);
#else
  // The triangle cuts the corner of the unit sphere: follow the view ray on, in object space, to where it meets the sphere
  // itself. |p + t d| = 1; in front of the middle the sphere lies towards the eye, beyond it away from the eye.
  vec3 p = (object_from_world * vec4(position, 1.0)).xyz;
  vec3 d = normalize(p - (object_from_world * vec4(eye, 1.0)).xyz);
  float b = dot(p, d), c = dot(p, p) - 1.0;
  float root = sqrt(max(b * b - c, 0.0));
  return normalize(normal_from_object * (p + (b < 0.0 ? -b - root : -b + root) * d));
#endif
}
