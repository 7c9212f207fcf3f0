// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "mesh/mesh.hpp"

namespace texel::mesh {

/// Says how evenly a texture lies on a mesh, in lines to read:
///
/// - how many triangles have no texture area (smeared: in none of the next figures), and how many show the
///   texture mirrored, seen from outside;
/// - the stretch, by area: how far a small move in the texture reaches on the surface, relative to what it
///   would reach if the same texture area were spread evenly. L2 is the root mean square over directions, L
///   infinity the greatest anywhere (P. Sander, J. Snyder, S. Gortler, H. Hoppe, "Texture Mapping Progressive
///   Meshes", SIGGRAPH 2001, section 3);
/// - the shear, by area: degrees between a right angle and the angle of s and t;
/// - how far the normals at the corners point from that of their own triangle, by area, in degrees. On a
///   curved surface that is what makes it look smooth, on a cube it is an error of the light.
///
/// Triangles without an area in space are ignored. Throws Error (exit 3) for a mesh without texture
/// coordinates or normals.
std::vector<std::string> describe_stretch(const Mesh& mesh);

}  // namespace texel::mesh
