// SPDX-License-Identifier: MIT
#pragma once
#include <glm/glm.hpp>

#include "mesh/mesh.hpp"

namespace texel::mesh {

/// How texture coordinates are made. "Centre" is that of the mesh's bounding box, "size" its longest side.
enum class Projection {
  planar,       ///< along z, seen from the front: (x, y) / size, so texels are square; smears the sides
  box,          ///< each triangle along the axis it faces most, upright as on a cube; (x, y) / size and so on
  cylindrical,  ///< about y: s the longitude from +z towards +x / 2 pi, t from the lowest to the highest
                ///< point
  spherical,    ///< about the centre: s the same, t the latitude from the south to the north pole / pi
};

/// Where the direction from the centre meets the unit square: s = longitude / 2 pi in [0, 1), 0 at +z and 1/4
/// at +x; t = latitude / pi + 1/2. The texture reads the right way round from outside (as on sphere() of
/// primitives.hpp). (0, 1/2) at the centre itself. Lab 3 teaches it:
/// labs/03_obj_texcoords/spherical_texcoord.cpp.
glm::vec2 spherical_texcoord(const glm::vec3& from_center);

/// Replaces the texture coordinates. Vertices are duplicated where triangles need different ones: in `box`
/// where neighbours face other axes. In the round projections at the seam, where a triangle continues past s
/// = 1, and on the axis, where s has no value and each triangle takes the mean of its other corners. Tangents
/// are emptied. Linear time. A triangle through which the axis passes keeps a stretch of at least half the
/// texture.
void generate_texcoords(Mesh& mesh, Projection projection);

/// How a texture lies on a surface that has one already: s' = stretch (s + shear t), and 1 - s' when
/// mirrored.
struct TextureLayout {
  float shear = 0.0F;    ///< 1: the lines of equal s lean by 45 degrees where the texture was square
  float stretch = 1.0F;  ///< positive: so many times as often along s
  bool mirror = false;
  bool operator==(const TextureLayout&) const = default;
};

/// Changes the layout. t stays, and s grows along the same line as before: existing tangents
/// stay exact, and are inverted when mirrored. Bitangents would lean; they are emptied.
void lay_texture(Mesh& mesh, const TextureLayout& layout);

}  // namespace texel::mesh
