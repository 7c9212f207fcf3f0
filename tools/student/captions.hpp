// SPDX-License-Identifier: MIT
#pragma once
#include "course/case.hpp"
#include "image/compared.hpp"

namespace texel::tools {

/// A student's picture, the expected one and where they differ, side by side, with a line below that says
/// which is which and what the colours of the last one mean.
image::Image8 with_captions(const image::Compared& pictures, course::Unit unit);

}  // namespace texel::tools
