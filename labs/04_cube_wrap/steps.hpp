// SPDX-License-Identifier: MIT
// What you write in the files beside lab.cpp. Each function says here what it is to do.
#pragma once
#include <array>
#include <glm/glm.hpp>

#include "mesh/mesh.hpp"

namespace texel::cube_wrap {

/// One texture coordinate for each of the cube's eight corners. Their order: front bottom left, front upper
/// left, front upper right, front bottom right, then the same at the back (left and right as seen from the
/// front).
using CubeTexcoords = std::array<glm::vec2, 8>;

/// The report's first table (section 3.2): the front is right, the back mirrored, the other faces smeared.
extern const CubeTexcoords cube_before;

/// The report's workaround (section 3.1): every face is covered, but the front is turned by 180 degrees, the
/// back mirrored, and one triangle of each other face is mirrored.
extern const CubeTexcoords cube_stretched;

/// The cube with separate vertices for each face. Where the two triangles of a face have equal corners, they
/// share a vertex; other triangles do not.
mesh::Mesh split_cube();

/// Merges vertices that are equal in every attribute (by value: -0 is +0), in order of first use; vertices
/// that no triangle uses are removed. Expected linear time.
mesh::Mesh weld(const mesh::Mesh& mesh);

/// The unit normal of the triangle a b c on the side from which it runs counter-clockwise; zero when it has
/// no area.
glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

}  // namespace texel::cube_wrap
