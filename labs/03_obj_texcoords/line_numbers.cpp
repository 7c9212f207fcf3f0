// SPDX-License-Identifier: MIT
// Step 3.1. What the numbers of a line are. The reader (common/mesh/obj.cpp) has split the line.
//   position_from  the position of a `v` line from its numbers, of which there are at least 3
//   texcoord_from  the texture coordinate of a `vt` line from its 1 to 3 numbers
#include "mesh/obj.hpp"

namespace texel::mesh {

//@step 3.1 begin
glm::vec3 position_from(std::span<const float> numbers) {
  return {numbers[0], numbers[1], numbers[2]};
}

glm::vec2 texcoord_from(std::span<const float> numbers) {
  return {numbers[0], numbers.size() > 1 ? numbers[1] : 0.0F};
}
//@starter
// // The model's shadow on the ground, drawn upright, and one point of the picture all over it.
// glm::vec3 position_from(std::span<const float> numbers) {
//   return {numbers[0], numbers[2], 0.0F};
// }
//
// glm::vec2 texcoord_from(std::span<const float> numbers) {
//   return {};
// }
//@end

}  // namespace texel::mesh
