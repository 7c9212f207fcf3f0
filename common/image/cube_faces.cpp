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
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const auto face = static_cast<Face>(2 * axis + (d[axis] < 0 ? 1 : 0));
  const dvec3 coordinate = d * axes(face);  // the dot products with the columns: sc, tc, |ma|
  return {face, 0.5 * (coordinate.x / coordinate.z + 1), 0.5 * (coordinate.y / coordinate.z + 1)};
}

}  // namespace texel::image
