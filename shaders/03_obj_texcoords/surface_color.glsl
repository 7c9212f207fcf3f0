// SPDX-License-Identifier: MIT
// The picture's colour at this pixel, and the coordinate at which it is read.
#include "lib/bounded_texcoord.glsl"
#include "lib/with_length.glsl"

#if METHOD == METHOD_PER_VERTEX
in vec3 vertex_color;
in vec2 fragment_texcoord;

vec2 surface_texcoord() { return fragment_texcoord; }

// Between two vertices there is no picture, only a blend of their texels.
vec3 surface_color() { return vertex_color; }

#elif PROJECTION == PROJECTION_TRIPLANAR
in vec3 object_coordinate;
in vec3 object_normal;

// The picture seen straight along each axis, the right way round from both sides.
vec2 along_x() {
  float across = object_normal.x > 0.0 ? -object_coordinate.z : object_coordinate.z;
  return vec2(across, object_coordinate.y) + 0.5;
}
vec2 along_y() {
  float up = object_normal.y > 0.0 ? -object_coordinate.z : object_coordinate.z;
  return vec2(object_coordinate.x, up) + 0.5;
}
vec2 along_z() {
  float across = object_normal.z < 0.0 ? -object_coordinate.x : object_coordinate.x;
  return vec2(across, object_coordinate.y) + 0.5;
}

// The weight of each axis: large if the surface faces it. The power limits the blend to nearly equal weights.
vec3 axis_weights() {
  vec3 weights = pow(abs(normalize(with_length(object_normal, vec3(0.0, 0.0, 1.0)))), vec3(6.0));
  return weights / (weights.x + weights.y + weights.z);
}

// The picture along the axis with the largest weight.
vec2 surface_texcoord() {
  vec3 weights = axis_weights();
  if (weights.z >= weights.x && weights.z >= weights.y) return along_z();
  return weights.x >= weights.y ? along_x() : along_y();
}

vec3 read(vec2 texcoord) { return texture(color_map, bounded_texcoord(texcoord)).rgb; }

vec3 surface_color() {
  vec3 weights = axis_weights();
  return weights.x * read(along_x()) + weights.y * read(along_y()) + weights.z * read(along_z());
}

#else
in vec2 fragment_texcoord;

vec2 surface_texcoord() { return fragment_texcoord; }

vec3 surface_color() { return texture(color_map, bounded_texcoord(fragment_texcoord)).rgb; }
#endif
