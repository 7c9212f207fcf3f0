// SPDX-License-Identifier: MIT
#pragma once
#include "procedural/noise.hpp"

namespace texel::test {

/// The i-th of a list of numbers in [0, 1) that stays the same; each axis has its own.
inline double number(int i, int axis) {
  return procedural::random(i, axis, 9);
}

}  // namespace texel::test
