// SPDX-License-Identifier: MIT
// error: the default is not one of the items
#include "params/set.hpp"

using namespace texel::params;

enum class Method { nearest, linear };
constexpr Item methods[] = {{"nearest", "The nearest texel"}, {"linear", "Four texels"}};

#ifdef WITHOUT_FAULT
constexpr File file("texture", "linear", methods, "The picture on the square");
#else
constexpr File file("texture", "brick", methods, "The picture on the square");
#endif
