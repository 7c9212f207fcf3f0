// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "image/difference.hpp"
#include "image/image.hpp"

namespace texel::image {

/// The colours of a data view, the same as in shaders/app/present.frag: 0.5 + 0.5 n for
/// directions, the fraction of texture coordinates, a scale of colours for levels. (0, 0, 0) is background,
/// NaN and infinity are magenta.
Image8 shown(const ImageF& values, const std::string& view);

/// A picture beside the expected one, as one looks at them: data views in colours.
struct Compared {
  Image8 own, expected;
  Image8 heat_map;     ///< of the error; `full_scale` has the hottest colour
  Difference figures;  ///< the pixel that has the error that was given
  double full_scale;   ///< this error, and not less than was asked for
};

/// `error` is what is told of the picture as its error; NaN stands for the largest. Errors that are small
/// beside `least_scale` are dark in the heat map, also where none is larger. Throws Error (exit 3) if the
/// sizes differ.
Compared compared(const Image8& own, const Image8& expected, double least_scale, double error);
/// Of a data view: its name, and whether its error is in degrees (Comparing).
Compared compared(const ImageF& own, const ImageF& expected, double least_scale, double error,
                  const std::string& view, bool in_degrees);

/// RGB pictures of one size from left to right, with grey gaps of 6 pixels. Each pixel becomes a square of
/// `zoom` pixels a side.
Image8 side_by_side(const std::vector<Image8>& pictures, int zoom = 1);

}  // namespace texel::image
