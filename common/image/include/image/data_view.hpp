// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "image/image.hpp"

namespace texel::image {

/// The colours in which the labs show a data view (shaders/app/present.frag has the same): 0.5 + 0.5 n for
/// directions, the fraction of texture coordinates, a scale of colours for levels. (0, 0, 0) is background,
/// NaN and infinity are magenta.
Image8 shown(const ImageF& values, const std::string& view);

}  // namespace texel::image
