#version 330 core
// SPDX-License-Identifier: MIT
// Passes on each vertex's texture coordinate, or the colour that was read there at import.
in vec3 position;
in vec3 normal;

uniform mat4 clip_from_world;
uniform mat4 world_from_object;  // a rotation, which turns normals as it turns positions
uniform float texture_scale;

out vec3 world_position;
out vec3 world_normal;

#if TINT == TINT_VERTICES
out vec3 vertex_tint;
#endif

#if METHOD == METHOD_PER_VERTEX
in vec3 color;
out vec3 vertex_color;
#endif

#if PROJECTION == PROJECTION_TRIPLANAR && METHOD == METHOD_PER_FRAGMENT
uniform float longest_side;  // of the box around the model, object space
out vec3 object_coordinate;  // the same scale as the box projection's
out vec3 object_normal;
#else
in vec2 texcoord;
out vec2 fragment_texcoord;
#endif

void main() {
  world_position = (world_from_object * vec4(position, 1.0)).xyz;
  world_normal = mat3(world_from_object) * normal;
#if TINT == TINT_VERTICES
  vertex_tint = fract(float(gl_VertexID % 4096) * vec3(0.618, 0.445, 0.275));  // unlike the next vertex's
#endif
#if METHOD == METHOD_PER_VERTEX
  vertex_color = color;
#endif
#if PROJECTION == PROJECTION_TRIPLANAR && METHOD == METHOD_PER_FRAGMENT
  object_coordinate = position / longest_side * texture_scale;
  object_normal = normal;
#else
  fragment_texcoord = texcoord * texture_scale;
#endif
  gl_Position = clip_from_world * vec4(world_position, 1.0);
}
