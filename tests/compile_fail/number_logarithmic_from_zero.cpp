// SPDX-License-Identifier: MIT
// error: a logarithmic range must be positive
#include "params/set.hpp"

using namespace texel::params;

enum class Method { nearest, linear };
constexpr Item methods[] = {{"nearest", "The nearest texel"}, {"linear", "Four texels"}};

#ifdef WITHOUT_FAULT
constexpr Number number("near", 1, 0.1, 10, "", "Distance of the near plane", Scale::logarithmic);
#else
constexpr Number number("near", 1, 0, 10, "", "Distance of the near plane", Scale::logarithmic);
#endif
