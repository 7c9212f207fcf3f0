// SPDX-License-Identifier: MIT
// error: a range goes from a smaller to a larger value
#include "params/set.hpp"

using namespace texel::params;

enum class Method { nearest, linear };
constexpr Item methods[] = {{"nearest", "The nearest texel"}, {"linear", "Four texels"}};

#ifdef WITHOUT_FAULT
constexpr Number number("tilt", 1, 0, 1, "degrees", "How far the quad leans back");
#else
constexpr Number number("tilt", 1, 1, 1, "degrees", "How far the quad leans back");
#endif
