// SPDX-License-Identifier: MIT
// Step 4.4. A vertex for each corner of each face.
#include "cube.hpp"

namespace texel::cube_wrap {

mesh::Mesh split_cube() {
  //@step 4.4 begin
  const mesh::ObjData data = cube_by_face(kHalfSize);
  mesh::Mesh cube;
  for (std::size_t i = 0; i < data.corners.size(); ++i) {
    const mesh::Corner& corner = data.corners[i];
    std::size_t equal = i - i % 6;  // where the face begins
    while (data.corners[equal] != corner) ++equal;
    if (equal < i) {
      cube.indices.push_back(cube.indices[equal]);
      continue;
    }
    cube.indices.push_back(static_cast<std::uint32_t>(cube.vertex_count()));
    cube.positions.push_back(data.positions[corner.position]);
    cube.texcoords.push_back(data.texcoords[corner.texcoord]);
    cube.normals.push_back(data.normals[corner.normal]);
  }
  return cube;
  //@starter
  // return cube_shared({}, kHalfSize);  // nothing is split yet
  //@end
}

}  // namespace texel::cube_wrap
