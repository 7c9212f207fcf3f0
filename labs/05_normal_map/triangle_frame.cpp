// SPDX-License-Identifier: MIT
// Step 5.2. The directions on a triangle in which the texture runs.
#include "mesh/tangents.hpp"

namespace texel::mesh {

TriangleFrame triangle_frame(const std::array<glm::vec3, 3>& positions,
                             const std::array<glm::vec2, 3>& texcoords) {
  //@step 5.2 begin
  const glm::vec3 e1 = positions[1] - positions[0];
  const glm::vec3 e2 = positions[2] - positions[1];
  const glm::vec2 d1 = texcoords[1] - texcoords[0];  // (ds1, dt1)
  const glm::vec2 d2 = texcoords[2] - texcoords[1];
  const float determinant = d1.s * d2.t - d2.s * d1.t;
  return {(d2.t * e1 - d1.t * e2) / determinant, (d1.s * e2 - d2.s * e1) / determinant};
  //@starter
  // // Solve E1 = ds1 T + dt1 B, E2 = ds2 T + dt2 B for T and B. Return {T, B}.
  // return {};
  //@end
}

}  // namespace texel::mesh
