// SPDX-License-Identifier: MIT
#pragma once
#include "image/image.hpp"

namespace texel::perception {

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
