// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "mesh/mesh.hpp"

/// Analytic shapes with exact normals and texture coordinates and no tangents; object space, right-handed, y
/// up, counter-clockwise seen from outside. Computed in double and rounded once. Sizes are in world units,
/// counts are clamped to the smallest that make a surface.
namespace texel::mesh {

/// Vertices slide along the exact surface, each by up to +-amount/2 of a cell in s and in t; below an amount
/// of 1/2 no triangle can turn over. The same seed gives the same mesh, and both copies of a seam's vertex
/// move alike. A plane's border and a sphere's poles stay where they are.
struct Jitter {
  float amount = 0.0F;
  std::uint32_t seed = 0;
};

/// A square in the plane z = 0 facing +z: corners (-h, -h) to (h, h), texture coordinates 0..1, cut into
/// cells x cells squares of two triangles.
Mesh quad(float half_size = 0.7F, int cells = 1, Jitter jitter = {});

/// A cube whose faces are such squares: each face has its own copy of the
/// whole texture, upright seen from outside (the top's lower edge and the bottom's upper edge are those at
/// the front). Faces +z, -z, +x, -x, +y, -y.
Mesh cube_split(float half_size = 1.0F, int cells = 1, Jitter jitter = {});

/// A sphere about the origin from `rings` bands of `segments` quads (at least 2 and 3):
/// s is the longitude / 2 pi, counter-clockwise seen from above, 0 at +z and 1/4 at +x; t is 0 at the south
/// and 1 at the north pole, even in latitude:
/// position = radius (cos(lat) sin(2 pi s), sin(lat), cos(lat) cos(2 pi s)), lat = pi (t - 1/2).
/// The seam's vertices are there twice (s = 0 and 1); each pole has one vertex a segment, at its middle s.
Mesh sphere(int rings, int segments, float radius = 1.0F, Jitter jitter = {});

/// A torus about the y axis: position = ((R + r cos b) sin a, r sin b, (R + r cos b) cos a) with a = 2 pi s
/// and b = 2 pi t. So s runs as on the sphere, and t = 0 is the outer equator. `segments` quads in s, `sides`
/// in t (at least 3); seams doubled.
Mesh torus(float major, float minor, int segments, int sides, Jitter jitter = {});

/// Fills the exact tangents of a surface of revolution about y with s as its longitude (sphere, torus):
/// T = (cos 2 pi s, 0, -sin 2 pi s), w = +1.
void revolution_tangents(Mesh& mesh);

}  // namespace texel::mesh
