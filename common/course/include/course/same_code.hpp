// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>

namespace texel::course {

/// Whether two texts of GLSL or C++ differ in comments and white space alone, so that they say the same to a
/// compiler. False where that takes more than a look: texts with a raw string, a digit separator, or a
/// backslash outside comments and literals must be equal byte by byte.
bool is_same_code(std::string_view a, std::string_view b);

}  // namespace texel::course
