// SPDX-License-Identifier: MIT
// error: two items have the same name
#include "params/set.hpp"

using namespace texel::params;

enum class Method { nearest, linear };
constexpr Item methods[] = {{"nearest", "The nearest texel"}, {"linear", "Four texels"}};
constexpr Item twice[] = {{"nearest", "The nearest texel"}, {"nearest", "Four texels"}};
#ifdef WITHOUT_FAULT
constexpr Choice<Method> choice("method", Method::nearest, methods, "How the texture is filtered");
#else
constexpr Choice<Method> choice("method", Method::nearest, twice, "How the texture is filtered");
#endif
