// SPDX-License-Identifier: MIT
// Step 5.7. A matrix that stretches a surface does something else to its normals.
#include "normal_matrix.hpp"

namespace texel::normal_map {

glm::mat3 normal_matrix(const glm::mat4& world_from_object) {
  //@step 5.7 begin
  // Under the inverse transpose of the surface's matrix a normal stays perpendicular to the surface.
  const glm::mat3 normal_from_object = glm::transpose(glm::inverse(glm::mat3(world_from_object)));
  //@starter
  // const glm::mat3 normal_from_object = glm::mat3(world_from_object);
  //@end
  return normal_from_object;
}

}  // namespace texel::normal_map
