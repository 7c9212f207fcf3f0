// SPDX-License-Identifier: MIT
#include "places.hpp"

namespace texel::test {

const char* const kBin = TEXEL_BIN;
const char* const kBuild = TEXEL_BUILD;
const char* const kSource = TEXEL_SOURCE;

}  // namespace texel::test
