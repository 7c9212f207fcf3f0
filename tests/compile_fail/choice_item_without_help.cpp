// SPDX-License-Identifier: MIT
// error: an item needs a name and a line of help
#include "params/set.hpp"

using namespace texel::params;

enum class Method { nearest, linear };
constexpr Item methods[] = {{"nearest", "The nearest texel"}, {"linear", "Four texels"}};
constexpr Item silent[] = {{"nearest", "The nearest texel"}, {"linear", ""}};
#ifdef WITHOUT_FAULT
constexpr Choice<Method> choice("method", Method::nearest, methods, "How the texture is filtered");
#else
constexpr Choice<Method> choice("method", Method::nearest, silent, "How the texture is filtered");
#endif
