// SPDX-License-Identifier: MIT
// error: a parameter needs a line of help
#include "params/set.hpp"

using namespace texel::params;

enum class Method { nearest, linear };
constexpr Item methods[] = {{"nearest", "The nearest texel"}, {"linear", "Four texels"}};

#ifdef WITHOUT_FAULT
constexpr Toggle toggle("flip_v", true, "Turns the picture over");
#else
constexpr Toggle toggle("flip_v", true, "");
#endif
