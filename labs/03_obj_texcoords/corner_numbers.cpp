// SPDX-License-Identifier: MIT
// Step 3.4. Corners become the vertices of the stream.
#include "mesh/corner_numbers.hpp"

namespace texel::mesh {

std::uint32_t CornerNumbers::number(const Corner& corner) {
  //@step 3.4 begin
  const std::uint32_t vertex =
      table_.number(hash_of(corner), [&](std::uint32_t known) { return distinct_[known] == corner; });
  if (vertex == distinct_.size()) distinct_.push_back(corner);
  return vertex;
  //@starter
  // // A new vertex for each corner: the picture is right, but the stream is several times too long.
  // distinct_.push_back(corner);
  // return static_cast<std::uint32_t>(distinct_.size() - 1);
  //@end
}

}  // namespace texel::mesh
