// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>

/// OBJ files that nobody has seen: whoever writes out what the bundled models look like fails with these.
namespace texel::material {

/// What unseen_model() can make:
/// - `numbers`: a relief whose lines have all counts of numbers that OBJ knows: `v` with 3, 4, 6 or 7, `vt`
///   with 1 to 3;
/// - `negative`: a relief written row by row, each index from the front or backwards, at random;
/// - `polygons`: planar simple polygons of 3 to 9 corners and combs of 11, turned at random in space, most of
///   them concave and none of those right as a fan. Texture coordinates are linear in each polygon's plane,
///   so that every correct triangulation draws the same picture and has the same angles at each corner;
/// - `shared`: a relief whose corners share positions, and often, but not always, vt or vn. One face is very
///   small, one has no area;
/// - `faces`: the same with few faces, so that each counts;
/// - `no_vt`: a dented ball without texture coordinates, about the middle of the cube.
/// All have normals (vn), 30 to 200 faces (`shared` more than a thousand: equal corners stand far apart), and
/// triangles only but for `polygons`; no two lines of a list are equal.
inline constexpr const char* kUnseenKinds[] = {"numbers", "negative", "polygons", "shared", "faces", "no_vt"};

/// The text of an OBJ file of this kind, every position within the unit cube, numbers with 6 decimals. The
/// same for the same seed, on every machine; another one for another seed. Throws Error (exit 2) for a kind
/// that does not exist, Error (exit 3) where the script unseen_model.py, which writes it, cannot be run.
std::string unseen_model(const std::string& kind, std::uint64_t seed);

}  // namespace texel::material
