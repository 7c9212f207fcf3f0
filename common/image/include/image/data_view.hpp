// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "image/image.hpp"

namespace texel::image {

/// The colours of a data view, the same as in shaders/app/present.frag: 0.5 + 0.5 n for
/// directions, the fraction of texture coordinates, a scale of colours for levels. (0, 0, 0) is background,
/// NaN and infinity are magenta.
Image8 shown(const ImageF& values, const std::string& view);

}  // namespace texel::image
