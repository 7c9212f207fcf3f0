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

/// The structural similarity of two pictures: 1 when they are the same, about 0 when they have nothing in
/// common, -1 at the least. Mean over pixels of (2 ma mb + C1)(2 cov + C2) / ((ma^2 + mb^2 + C1)(va + vb +
/// C2)), where means, variances and covariance are of the luma around the pixel, weighted by a Gaussian of
/// sigma 1.5 over 11x11 pixels that add up to 1; C1 = (0.01 * 255)^2, C2 = (0.03 * 255)^2.
/// Luma is 0.299 R + 0.587 G + 0.114 B of the encoded 8-bit values (ITU-R BT.601), alpha is left out. The
/// original takes only pixels whose window lies within the picture; here every pixel counts, so that small
/// pictures and masks work, and beyond the border the picture goes on as its border pixels. With a mask only
/// pixels whose first mask channel is above 0 count; their windows reach beyond it. Throws Error (exit 3)
/// when the sizes differ or no pixel is left. Source: Z. Wang, A. C. Bovik, H. R. Sheikh, E. P. Simoncelli,
/// "Image Quality Assessment: From Error Visibility to Structural Similarity", IEEE Trans. Image Processing
/// 13(4), 2004, equation 13.
double ssim(const image::Image8& reference, const image::Image8& image, const image::Image8* mask = nullptr);

}  // namespace texel::perception
