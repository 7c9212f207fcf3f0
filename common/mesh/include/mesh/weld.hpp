// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/mesh.hpp"
#include "mesh/obj.hpp"

namespace texel::mesh {

/// The stream for the GPU from an OBJ file's separate lists: one vertex for each distinct corner (v, vt, vn),
/// numbered in order of first use, triangles grouped by material in order of first use. Corners without vt
/// get (0, 0) where others have one; normals that are missing where others have one are generated
/// (normals.hpp) and all are made unit length; where no corner has a vt (vn), the mesh has no texcoords
/// (normals). Expected linear time. Pass the data with std::move to spare a copy.
Mesh weld(ObjData data);

/// The mesh with only these vertices, in this order; its indices are left empty.
Mesh take_vertices(const Mesh& mesh, const std::vector<std::uint32_t>& vertices);

/// Gives each triangle three vertices of its own, in order: positions[i] belongs to the i-th index.
Mesh split(const Mesh& mesh);

/// Appends a copy of one vertex with all its attributes and returns its index.
std::uint32_t duplicate_vertex(Mesh& mesh, std::uint32_t vertex);

/// Duplicates vertices until all corners of a vertex have the same label. The first label keeps the vertex,
/// each further one gets a copy of it, appended. `labels` has one for each index, no_index for corners
/// without one. Returns the label of each vertex (no_index for those without one). Expected linear time.
std::vector<std::uint32_t> split_by_label(Mesh& mesh, std::span<const std::uint32_t> labels);

}  // namespace texel::mesh
