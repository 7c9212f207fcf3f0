// SPDX-License-Identifier: MIT
#include "image/cube_faces.hpp"

#include <glm/common.hpp>

namespace texel::image {

using glm::dvec3;

const glm::dmat3& axes(Face face) {
  static const glm::dmat3 all[] = {{dvec3(0, 0, -1), dvec3(0, -1, 0), dvec3(1, 0, 0)},
                                   {dvec3(0, 0, 1), dvec3(0, -1, 0), dvec3(-1, 0, 0)},
                                   {dvec3(1, 0, 0), dvec3(0, 0, 1), dvec3(0, 1, 0)},
                                   {dvec3(1, 0, 0), dvec3(0, 0, -1), dvec3(0, -1, 0)},
                                   {dvec3(1, 0, 0), dvec3(0, -1, 0), dvec3(0, 0, 1)},
                                   {dvec3(-1, 0, 0), dvec3(0, -1, 0), dvec3(0, 0, -1)}};
  return all[static_cast<int>(face)];
}

FaceCoordinate face_coordinate(const dvec3& d) {
  const dvec3 size = glm::abs(d);
  Face face = d.z < 0 ? Face::negative_z : Face::positive_z;
  if (size.x >= size.y && size.x >= size.z) {
    face = d.x < 0 ? Face::negative_x : Face::positive_x;
  } else if (size.y >= size.z) {
    face = d.y < 0 ? Face::negative_y : Face::positive_y;
  }
  const dvec3 coordinate = d * axes(face);  // the dot products with the columns: sc, tc, |ma|
  return {face, 0.5 * (coordinate.x / coordinate.z + 1), 0.5 * (coordinate.y / coordinate.z + 1)};
}

}  // namespace texel::image
