// SPDX-License-Identifier: MIT
#pragma once
#include "params/set.hpp"

namespace texel::app {

/// Declares what the view `error` compares. A student's tree has no such view: there the variable only gets
/// its default.
template <class Enum>
void declare_truth([[maybe_unused]] params::Set& set, Enum& variable,
                   params::Choice<std::type_identity_t<Enum>> truth) {
#ifdef TEXEL_KNOWS_TRUTH
  set.section("Error");
  set.add(variable, truth);
#else
  variable = truth.initial;
#endif
}

}  // namespace texel::app
