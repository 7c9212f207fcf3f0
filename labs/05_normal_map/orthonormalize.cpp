// SPDX-License-Identifier: MIT
// Step 5.4. A tangent in the surface, and the bitangent's side.
#include "mesh/tangents.hpp"
#include "mesh/vectors.hpp"

namespace texel::mesh {

glm::vec4 orthonormalize(const glm::vec3& normal, const glm::vec3& tangent, const glm::vec3& bitangent) {
  //@step 5.4 begin
  const glm::vec3 in_plane = unit_or_zero(tangent - normal * glm::dot(normal, tangent));
  const float side = glm::dot(glm::cross(normal, in_plane), bitangent) < 0.0F ? -1.0F : 1.0F;
  return {in_plane, side};
  //@starter
  // // Take away the part along the normal, then find on which side the bitangent lies.
  // return {tangent, 1.0F};
  //@end
}

}  // namespace texel::mesh
