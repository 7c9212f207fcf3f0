// SPDX-License-Identifier: MIT
// error: the default is not one of the items
#include "params/set.hpp"

using namespace texel::params;

enum class Method { nearest, linear };
constexpr Item methods[] = {{"nearest", "The nearest texel"}, {"linear", "Four texels"}};

#ifdef WITHOUT_FAULT
constexpr Choice<Method> choice("method", Method::linear, methods, "How the texture is filtered");
#else
constexpr Choice<Method> choice("method", static_cast<Method>(2), methods, "How the texture is filtered");
#endif
