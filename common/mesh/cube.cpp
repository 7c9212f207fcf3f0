// SPDX-License-Identifier: MIT
#include "mesh/cube.hpp"

#include <cstdint>

namespace texel::mesh {

namespace {

constexpr std::array<glm::vec3, 8> corners{
    {{-1, -1, 1}, {-1, 1, 1}, {1, 1, 1}, {1, -1, 1}, {-1, -1, -1}, {-1, 1, -1}, {1, 1, -1}, {1, -1, -1}}};

/// Each face's corners, counter-clockwise from its lower left seen from outside, and its normal.
struct Face {
  std::array<std::uint32_t, 4> corners;
  glm::vec3 normal;
};
constexpr std::array<Face, 6> faces{{{{0, 3, 2, 1}, {0, 0, 1}},
                                     {{7, 4, 5, 6}, {0, 0, -1}},
                                     {{3, 7, 6, 2}, {1, 0, 0}},
                                     {{4, 0, 1, 5}, {-1, 0, 0}},
                                     {{1, 2, 6, 5}, {0, 1, 0}},
                                     {{4, 7, 3, 0}, {0, -1, 0}}}};
/// The two triangles of a face.
constexpr std::array<std::uint32_t, 6> cut{0, 1, 2, 0, 2, 3};

}  // namespace

//@step 4.1 begin
const CubeTexcoords cube_before{{{0, 0}, {0, 1}, {1, 1}, {1, 0}, {0, 0}, {0, 1}, {1, 1}, {1, 0}}};
//@starter
// const CubeTexcoords cube_before{
//     {{0, 0}, {0, 0}, {1, 1}, {1, 1}, {0, 0}, {0, 0}, {1, 1}, {1, 1}}};
//@end

//@step 4.1 begin
const CubeTexcoords cube_stretched{{{1, 1}, {1, 0}, {0, 0}, {0, 1}, {0, 0}, {0, 1}, {1, 1}, {1, 0}}};
//@starter
// const CubeTexcoords cube_stretched{
//     {{0, 0}, {0, 0}, {1, 1}, {1, 1}, {0, 0}, {0, 0}, {1, 1}, {1, 1}}};
//@end

Mesh cube_shared(const CubeTexcoords& texcoords, float half_size) {
  Mesh mesh;
  for (const glm::vec3& corner : corners) {
    mesh.positions.push_back(half_size * corner);
    mesh.normals.push_back(glm::normalize(corner));
  }
  mesh.texcoords.assign(texcoords.begin(), texcoords.end());
  for (const Face& face : faces)
    for (const std::uint32_t k : cut) mesh.indices.push_back(face.corners[k]);
  return mesh;
}

ObjData cube_by_face(float half_size) {
  ObjData data;
  data.name = "cube";
  for (const glm::vec3& corner : corners) data.positions.push_back(half_size * corner);
  data.texcoords = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  for (const Face& face : faces) {
    const auto normal = static_cast<std::uint32_t>(data.normals.size());
    data.normals.push_back(face.normal);
    for (const std::uint32_t k : cut) data.corners.push_back({face.corners[k], k, normal});
  }
  return data;
}

}  // namespace texel::mesh
