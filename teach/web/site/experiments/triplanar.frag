#version 330 core
// SPDX-License-Identifier: MIT
// Triplanar mapping: no texture coordinates. The picture is projected along
// x, y and z, and the normal says how much of each is seen.
// R. Geiss, "Generating Complex Procedural Terrains Using the GPU",
// GPU Gems 3 (2007).
// Try: kSharpness 1 and 32; `method`, which changes nothing any more. On
// which sides are the letters mirrored, and what does sign(normal) help?
in vec3 world_position;
in vec3 world_normal;
in vec2 fragment_texcoord;

uniform sampler2D color_map;
uniform mat4 world_from_object;  // a rotation
uniform vec3 eye;    // world space
uniform vec3 light;  // world space, unit vector towards the light
uniform float ambient;
uniform float specular;

#include "lib/light.glsl"
#include "lib/picture.glsl"

const float kSharpness = 6.0;  // 1: wide seams between the three pictures
const float kScale = 0.87;     // widths of the texture in a unit of length

vec3 triplanar(vec3 position, vec3 normal) {
  vec3 weight = pow(abs(normal), vec3(kSharpness));
  weight /= weight.x + weight.y + weight.z;
  vec3 st = kScale * position + 0.5;
  return weight.x * texture(color_map, st.zy).rgb + weight.y * texture(color_map, st.xz).rgb +
         weight.z * texture(color_map, st.xy).rgb;
}

void main() {
  vec3 normal = normalize(world_normal);
  // A vector before a matrix: by its transpose, which is the rotation back.
  // So the pictures turn with the object.
  vec3 position = world_position * mat3(world_from_object), upright = normal * mat3(world_from_object);
#if VIEW == VIEW_NORMAL
  picture = vec4(normal, 1.0);
#elif VIEW == VIEW_TEXCOORD
  picture = vec4(fragment_texcoord, 0.0, 1.0);  // what the mesh has, and nobody reads
#elif VIEW == VIEW_LOD
  picture = vec4(vec3(0.0), 1.0);
#else
  show(vec4(lit(triplanar(position, upright), normal, normalize(eye - world_position)), 1.0));
#endif
}
