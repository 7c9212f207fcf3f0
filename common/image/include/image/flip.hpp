// SPDX-License-Identifier: MIT
#pragma once
#include <numbers>

#include "image/image.hpp"

namespace texel::image {

/// The paper's viewer: 0.7 m before a display that is 0.7 m wide and has 3840 pixels, 67.02 pixels a degree.
inline constexpr double default_pixels_per_degree = 3840 * std::numbers::pi / 180;

/// FLIP for pictures of low dynamic range: how much a viewer sees at each pixel when alternating between the
/// two, 0 (nothing) to 1. Colours are filtered like in the eye, then compared. A difference in edges or
/// points raises the error. Symmetric in the two pictures. R, G and B are sRGB-encoded, grey counts as R = G
/// = B, alpha is ignored; beyond the border the border pixels are repeated. `pixels_per_degree` of
/// visual angle is 1 to 1000. One channel, within 1e-4 of the same in double precision. Throws Error (exit 3)
/// when the sizes differ or the pictures are empty, and Error (usage) beyond 1 to 1000 pixels a degree.
/// Source: P. Andersson, J. Nilsson, T. Akenine-Moeller, M. Oskarsson, K. Astrom, M. D. Fairchild, "FLIP: A
/// Difference Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020.
ImageF flip_errors(const Image8& reference, const Image8& image,
                   double pixels_per_degree = default_pixels_per_degree);

/// An error map in a few numbers. A weighted percentile weights each pixel by its error: half of all
/// error lies in pixels with at most the error of the weighted median. A large background without
/// error does not count. 0 when there is no error.
struct FlipFigures {
  double mean = 0;
  double p99 = 0;             ///< over pixels, nearest rank as in `Difference`
  double first_quartile = 0;  ///< weighted
  double median = 0;          ///< weighted
  double third_quartile = 0;  ///< weighted
};

/// Pools an error map in double precision, over the pixels whose first mask channel is above 0. Throws Error
/// (exit 3) when the sizes differ or no pixel is left.
/// Source of the weighted percentiles: P. Andersson, J. Nilsson, T. Akenine-Moeller, "Visualizing and
/// Communicating Errors in Rendered Images", Ray Tracing Gems II, 2021.
FlipFigures flip_figures(const ImageF& errors, const Image8* mask = nullptr);

/// The error map in the colours of the magma map (S. van der Walt, N. Smith, 2015), which FLIP's authors use:
/// black for 0 over violet and orange to pale yellow for 1. Masked pixels are black. Throws Error (exit 3)
/// when the sizes differ.
Image8 flip_heatmap(const ImageF& errors, const Image8* mask = nullptr);

}  // namespace texel::image
