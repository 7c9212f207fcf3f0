// SPDX-License-Identifier: MIT
// Step 5.3. Triangles that share a vertex share its frame.
#include "mesh/tangents.hpp"

namespace texel::mesh {

void add_to_corners(const std::array<std::uint32_t, 3>& corners, const TriangleFrame& frame,
                    std::vector<TriangleFrame>& sums) {
  //@step 5.3 begin
  for (const std::uint32_t corner : corners) {
    sums[corner].tangent += frame.tangent;
    sums[corner].bitangent += frame.bitangent;
  }
  //@starter
  // // Each triangle overwrites what the ones before it left at its vertices.
  // sums[corners[0]] = sums[corners[1]] = sums[corners[2]] = frame;
  //@end
}

}  // namespace texel::mesh
