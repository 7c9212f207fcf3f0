// SPDX-License-Identifier: MIT
// A vertex passes on only the tangents that the method reads. A tangent lies in the surface, so it
// moves with the surface.
#include "methods.glsl"

#if STORED_TANGENT || STORED_BITANGENT
in vec4 tangent;
out vec4 world_tangent;  // w: the bitangent's sign
#endif
#if STORED_BITANGENT
in vec3 bitangent;
out vec3 world_bitangent;
#endif

void pass_on_tangents(mat3 world_from_object) {
#if STORED_TANGENT || STORED_BITANGENT
  world_tangent = vec4(normalize(world_from_object * tangent.xyz), tangent.w);
#endif
#if STORED_BITANGENT
  world_bitangent = normalize(world_from_object * bitangent);
#endif
}
