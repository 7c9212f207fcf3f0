// SPDX-License-Identifier: MIT
// Step 3.2. Which entry of a list an index of a face means: 1 is the first entry, -1 the last one. `written`
// is not 0.
#include "mesh/obj.hpp"

namespace texel::mesh {

std::int64_t resolve_index(std::int64_t written, std::int64_t count) {
  //@step 3.2 begin
  return written > 0 ? written - 1 : count + written;
  //@starter
  // return written - 1;  // the files that count backwards are refused
  //@end
}

}  // namespace texel::mesh
