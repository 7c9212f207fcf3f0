// SPDX-License-Identifier: MIT
// Step 4.3. A triangle's normal.
#include "mesh/vectors.hpp"
#include "steps.hpp"

namespace texel::cube_wrap {

using mesh::unit_or_zero;

glm::vec3 face_normal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  //@step 4.3 begin
  return unit_or_zero(glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a)));
  //@starter
  // return {};
  //@end
}

}  // namespace texel::cube_wrap
