// SPDX-License-Identifier: MIT
// The cube that is wrapped: eight corners, six faces. The front is +z. Nothing to do for you here.
#pragma once
#include <array>
#include <cstdint>

#include "mesh/obj.hpp"
#include "steps.hpp"

namespace texel::cube_wrap {

constexpr float kHalfSize = 0.577F;  // the corners at distance 1

/// In the order of CubeTexcoords.
inline constexpr std::array<glm::vec3, 8> kCubeCorners{
    {{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}, {-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}}};

/// Each face's corners, counter-clockwise from its lower left seen from outside, and its normal.
struct CubeFace {
  std::array<std::uint32_t, 4> corners;
  glm::vec3 normal;
};
inline constexpr std::array<CubeFace, 6> kCubeFaces{{{{0, 3, 2, 1}, {0, 0, 1}},
                                                     {{7, 4, 5, 6}, {0, 0, -1}},
                                                     {{3, 7, 6, 2}, {1, 0, 0}},
                                                     {{4, 0, 1, 5}, {-1, 0, 0}},
                                                     {{1, 2, 6, 5}, {0, 1, 0}},
                                                     {{4, 7, 3, 0}, {0, -1, 0}}}};
/// The two triangles of a face.
inline constexpr std::array<std::uint32_t, 6> kCut{0, 1, 2, 0, 2, 3};

/// The report's cube: 8 vertices, 12 triangles. The normals point away from the centre, because a shared
/// vertex has only one.
inline mesh::Mesh cube_shared(const CubeTexcoords& texcoords, float half_size = 1) {
  mesh::Mesh mesh;
  for (const glm::vec3& corner : kCubeCorners) {
    mesh.positions.push_back(half_size * corner);
    mesh.normals.push_back(glm::normalize(corner));
  }
  mesh.texcoords.assign(texcoords.begin(), texcoords.end());
  for (const CubeFace& face : kCubeFaces)
    for (const std::uint32_t k : kCut) mesh.indices.push_back(face.corners[k]);
  return mesh;
}

/// The same cube as an exporter writes it: 8 v, 4 vt, 6 vn, each face with the whole texture upright seen
/// from outside. Each v has three different vn, so 24 vertices are needed.
inline mesh::ObjData cube_by_face(float half_size = 1) {
  mesh::ObjData data;
  for (const glm::vec3& corner : kCubeCorners) data.positions.push_back(half_size * corner);
  data.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const CubeFace& face : kCubeFaces) {
    const auto normal = static_cast<std::uint32_t>(data.normals.size());
    data.normals.push_back(face.normal);
    for (const std::uint32_t k : kCut) data.corners.push_back({face.corners[k], k, normal});
  }
  return data;
}

}  // namespace texel::cube_wrap
