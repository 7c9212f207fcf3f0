// SPDX-License-Identifier: MIT
// error: a parameter's name is snake_case
#include "params/set.hpp"

using namespace texel::params;

enum class Method { nearest, linear };
constexpr Item methods[] = {{"nearest", "The nearest texel"}, {"linear", "Four texels"}};

#ifdef WITHOUT_FAULT
constexpr Toggle toggle("flip", true, "Turns the picture over");
#else
constexpr Toggle toggle("flip_", true, "Turns the picture over");
#endif
