// SPDX-License-Identifier: MIT
// The frame of the surface at this pixel, in world space: columns T (where s grows), B (where t grows), N.
#include "methods.glsl"

#if STORED_BITANGENT
in vec4 world_tangent;
in vec3 world_bitangent;

// Three interpolated vectors, made unit vectors again, but not orthogonal (slides).
mat3 tangent_frame() {
  return mat3(normalize(world_tangent.xyz), normalize(world_bitangent), normalize(world_normal));
}

#elif STORED_TANGENT
in vec4 world_tangent;

// Step 5.5. The frame from the interpolated normal and tangent. The sign w says on which side B lies.
mat3 tangent_frame() {
  //@step 5.5 begin
#if METHOD == METHOD_MIKKTSPACE
  // Baking programs interpolate and do not make unit vectors again. Decoding must do the same.
  vec3 N = world_normal;
  vec3 T = world_tangent.xyz;
#else
  vec3 N = normalize(world_normal);
  vec3 T = normalize(world_tangent.xyz - dot(world_tangent.xyz, N) * N);
#endif
  vec3 B = world_tangent.w * cross(N, T);
  return mat3(T, B, N);
  //@starter
  // return mat3(world_tangent.xyz, vec3(0.0, 1.0, 0.0), world_normal);
  //@end
}

#elif NORMAL_MAPPING && METHOD == METHOD_SCREEN_AXES
// As the report prints it (section 3.3). dFdx of a position points along the screen's x axis, not along the
// texture's s. Also, a position already in view or world space is multiplied by the model matrix again.
mat3 tangent_frame() {
  vec3 xTangent = dFdx(world_position);
  vec3 yTangent = dFdy(world_position);
  vec3 faceNormal = normalize(cross(xTangent, yTangent));
  vec3 T = normalize(vec3(world_from_object * vec4(xTangent, 0.0)));
  vec3 B = normalize(vec3(world_from_object * vec4(yTangent, 0.0)));
  vec3 N = normalize(vec3(world_from_object * vec4(faceNormal, 0.0)));
  return mat3(T, B, N);
}

#else
// Step 5.6. The frame from how position and texture coordinate change between this pixel and its neighbours. In the
// plane, T and B fulfil T . dp = ds and B . dp = dt for both neighbours, up to one common factor.
// C. Schueler, "Normal Mapping Without Precomputed Tangents", ShaderX 5 (2006).
mat3 tangent_frame() {
  vec3 N = normalize(world_normal);
  //@step 5.6 begin
  vec3 dp_dx = dFdx(world_position), dp_dy = dFdy(world_position);
  vec2 dt_dx = dFdx(fragment_texcoord), dt_dy = dFdy(fragment_texcoord);
  vec3 across_y = cross(dp_dy, N), across_x = cross(N, dp_dx);  // perpendicular to the other edge, in the plane
  vec3 T = across_y * dt_dx.x + across_x * dt_dy.x;
  vec3 B = across_y * dt_dx.y + across_x * dt_dy.y;
  float longer = max(dot(T, T), dot(B, B));
  float scale = longer > 0.0 ? inversesqrt(longer) : 0.0;  // no texture area: N alone
  return mat3(T * scale, B * scale, N);
  //@starter
  // return mat3(dFdx(world_position), dFdy(world_position), N);
  //@end
}
#endif
