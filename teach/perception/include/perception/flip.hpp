// SPDX-License-Identifier: MIT
#pragma once
#include <numbers>

#include "image/image.hpp"

namespace texel::perception {

/// The paper's viewer: 0.7 m before a display that is 0.7 m wide and has 3840 pixels, 67.02 pixels a degree.
inline constexpr double pixels_per_degree = 3840 * std::numbers::pi / 180;

/// FLIP for pictures of low dynamic range: how much a viewer sees at each pixel when alternating between the
/// two, 0 (nothing) to 1. Colours are filtered like in the eye, then compared. A difference in edges or
/// points raises the error. Symmetric in the two pictures. R, G and B are sRGB-encoded, grey counts as R = G
/// = B, alpha is ignored; beyond the border the border pixels are repeated. One channel, within 1e-4 of the
/// same in double precision. Throws Error (exit 3) when the sizes differ or the pictures are empty.
/// Source: P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astrom, M. D. Fairchild, "FLIP: A
/// Difference Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
image::ImageF flip_errors(const image::Image8& reference, const image::Image8& image);

/// An error map in a few numbers.
struct FlipFigures {
  double mean = 0;
  double p99 = 0;  ///< over pixels, nearest rank as in `Difference`
};

/// Pools an error map in double precision, over the pixels whose first mask channel is above 0. Throws Error
/// (exit 3) when the sizes differ or no pixel is left.
FlipFigures flip_figures(const image::ImageF& errors, const image::Image8* mask = nullptr);

}  // namespace texel::perception
