#version 330 core
// SPDX-License-Identifier: MIT
// A bumpy mirror: coordinates, map, frame, reflection.
#include "coordinates.glsl"
#include "frame.glsl"
#include "map_normal.glsl"
#include "reflect_ray.glsl"
#include "roughness.glsl"
#include "lib/picture.glsl"
#include "lib/with_length.glsl"

in vec3 object_normal;
in vec3 world_position;

uniform samplerCube cube_map;
uniform mat4 world_from_object;

void main() {
  vec3 n = normalize(object_normal);
  vec3 bent = n;
#if NORMAL_MAPPING
  vec3 color = read_map(n);
  bent = bent_normal(n, with_length(map_normal(color), vec3(0.0, 0.0, 1.0)));
#endif
  vec3 normal = mat3(world_from_object) * bent;  // a rotation
  vec3 direction = reflected_ray(world_position, normal);
#if VIEW == VIEW_NORMAL
  picture = vec4(normalize(normal), 1.0);
#elif VIEW == VIEW_TANGENT
  picture = vec4(mat3(world_from_object) * frame_at(n)[0], 1.0);
#elif VIEW == VIEW_DIRECTION
  picture = vec4(normalize(direction), 1.0);
#elif VIEW == VIEW_TEXCOORD
  picture = vec4(map_texcoord(n), 0.0, 1.0);
#elif NORMAL_MAPPING && MIP_FILTER == MIP_FILTER_TOKSVIG
  show(vec4(rough_reflection(cube_map, direction, color).rgb, 1.0));
#else
  show(vec4(texture(cube_map, direction).rgb, 1.0));
#endif
}
