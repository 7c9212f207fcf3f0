// SPDX-License-Identifier: MIT
// Step 4.1. The report's two tables: one texture coordinate for each of the eight corners. Corner order:
// front bottom left, front upper left, front upper right, front bottom right, then the same at the back, left
// and right as seen from the front.
#include "steps.hpp"

namespace texel::cube_wrap {

//@step 4.1 begin
const CubeTexcoords cube_before{{{0, 0}, {0, 1}, {1, 1}, {1, 0}, {0, 0}, {0, 1}, {1, 1}, {1, 0}}};
//@starter
// const CubeTexcoords cube_before{
//     {{0, 0}, {0, 0}, {1, 1}, {1, 1}, {0, 0}, {0, 0}, {1, 1}, {1, 1}}};
//@end

//@step 4.1 begin
const CubeTexcoords cube_stretched{{{1, 1}, {1, 0}, {0, 0}, {0, 1}, {0, 0}, {0, 1}, {1, 1}, {1, 0}}};
//@starter
// const CubeTexcoords cube_stretched{
//     {{0, 0}, {0, 0}, {1, 1}, {1, 1}, {0, 0}, {0, 0}, {1, 1}, {1, 1}}};
//@end

}  // namespace texel::cube_wrap
