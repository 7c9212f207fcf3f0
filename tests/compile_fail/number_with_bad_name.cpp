// SPDX-License-Identifier: MIT
// error: a parameter's name is snake_case
#include "params/set.hpp"

using namespace texel::params;

enum class Method { nearest, linear };
constexpr Item methods[] = {{"nearest", "The nearest texel"}, {"linear", "Four texels"}};

#ifdef WITHOUT_FAULT
constexpr Number number("bump_strength", 1, 0, 4, "", "How deep the bumps are");
#else
constexpr Number number("BumpStrength", 1, 0, 4, "", "How deep the bumps are");
#endif
