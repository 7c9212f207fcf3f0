// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace texel::mesh {

/// How evenly a texture lies on a mesh. The stretch is how far a small move in the texture reaches on the
/// surface, relative to what it would reach if the same texture area were spread evenly: 1 is perfect
/// (P. Sander, J. Snyder, S. Gortler, H. Hoppe, "Texture Mapping Progressive Meshes", SIGGRAPH 2001,
/// section 3). Triangles without texture area have infinite stretch: they are only counted. All figures are 0
/// when no triangle has one. Triangles without an area in space are ignored.
struct Stretch {
  double l2 = 0;                          ///< root mean square over directions and, by area, over the surface
  double l_infinity = 0;                  ///< the greatest anywhere
  double mean_shear = 0;                  ///< by area: degrees between a right angle and the angle of s and t
  double max_shear = 0;                   ///< degrees, 0 to 90
  std::uint32_t zero_area_triangles = 0;  ///< their three texture coordinates lie on a line: smeared
  std::uint32_t mirrored_triangles = 0;   ///< the texture reads backwards seen from outside

  /// How far the normals at the corners point from that of their own triangle, in degrees; the mean is by
  /// area. On a curved surface that is what makes it look smooth, on a cube it is an error of the light.
  double mean_deviation = 0, max_deviation = 0;
};

/// Throws Error (exit 3) for a mesh without texture coordinates or normals.
Stretch measure_stretch(const Mesh& mesh);

/// The same as lines to read.
std::vector<std::string> describe_stretch(const Mesh& mesh);

}  // namespace texel::mesh
