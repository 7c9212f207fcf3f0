// SPDX-License-Identifier: MIT
// error: the default is outside the range
#include "params/set.hpp"

using namespace texel::params;

enum class Method { nearest, linear };
constexpr Item methods[] = {{"nearest", "The nearest texel"}, {"linear", "Four texels"}};

#ifdef WITHOUT_FAULT
constexpr Number number("tilt", 60, -89, 89, "degrees", "How far the quad leans back");
#else
constexpr Number number("tilt", 90, -89, 89, "degrees", "How far the quad leans back");
#endif
