// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

#include "mesh/mesh.hpp"

namespace texel::mesh {

/// A vertex stream as a binary little-endian PLY file: float32 properties x y z, and of nx ny nz, s t,
/// tx ty tz tw those that the mesh has (tw is the bitangent's sign); faces as uchar count and int32 indices.
/// Colours, own bitangents and groups are not kept.
std::string to_ply(const Mesh& mesh);

/// Reads such a file, and only such: these properties in this order, triangles. Throws Error (exit 3) with
/// `name` for anything else, for indices out of range, for a file that is cut off or too long, and for
/// non-finite values.
Mesh parse_ply(std::string_view bytes, const std::string& name);

}  // namespace texel::mesh
