// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <glm/glm.hpp>

#include "mesh/mesh.hpp"
#include "mesh/obj.hpp"

/// The report's cube of eight shared vertices, and the cube whose faces each have a copy of the texture.
/// Corner order: front bottom left, front upper left, front upper right, front bottom right, then the same at
/// the back (left and right as seen from the front); the front is +z.
namespace texel::mesh {

/// One texture coordinate for each of the eight corners.
using CubeTexcoords = std::array<glm::vec2, 8>;

/// The report's first table (section 3.2): the front is right, the back mirrored, the other faces smeared.
extern const CubeTexcoords cube_before;

/// The report's workaround (section 3.1): every face is covered, but the front is turned by 180 degrees, the
/// back mirrored, and one triangle of each other face is mirrored.
extern const CubeTexcoords cube_stretched;

/// The report's cube: 8 vertices, 12 triangles. The normals point away from the centre, because a shared
/// vertex has only one.
Mesh cube_shared(const CubeTexcoords& texcoords, float half_size = 1.0f);

/// The same cube as an exporter writes it: 8 v, 4 vt, 6 vn, each face with the whole texture upright seen
/// from outside. weld() makes 24 vertices of it, since each v has three different vn.
ObjData cube_by_face(float half_size = 1.0f);

}  // namespace texel::mesh
