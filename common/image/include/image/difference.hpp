// SPDX-License-Identifier: MIT
#pragma once
#include "image/image.hpp"

namespace texel::image {

/// How far one picture is from another.
struct Difference {
  int width = 0;             ///< pixels
  int height = 0;            ///< pixels
  double max = 0;            ///< the largest difference
  double mean = 0;           ///< the mean over samples (over pixels for directions)
  double p99 = 0;            ///< the 99th percentile over pixels of each pixel's largest difference
  long long non_finite = 0;  ///< pixels with NaN or infinity in either picture: in none of the figures above
};

/// How the samples of float pictures are compared.
enum class Unit {
  own,     ///< sample by sample, in the pictures' own unit
  degrees  ///< R, G and B as a vector of any length: the angle between the two pictures' vectors
};

/// Compares R, G and B in 8-bit steps; grey counts as R = G = B and alpha is left out. With a mask only
/// pixels whose first mask channel is above 0 count. The percentile is the nearest rank: of n pixels sorted
/// upwards the value at rank ceil(0.99 n). Throws Error (exit 3) when the sizes differ or the mask leaves no
/// pixel.
Difference compare(const Image8& reference, const Image8& image, const Image8* mask = nullptr);

/// Compares float pictures in the given unit. A pixel with NaN or infinity in either picture is counted in
/// `non_finite` and left out. For directions (3 or 4 channels) the angle is
/// atan2(|a x b|, a . b), exact for small angles too; a pixel that is (0, 0, 0) in both is background and
/// left out, in one only it is 180 degrees off. When no pixel is left the figures are 0. Throws Error (exit
/// 3) when the sizes or channels differ or directions have fewer than 3 channels.
Difference compare(const ImageF& reference, const ImageF& image, Unit unit, const Image8* mask = nullptr);

/// Each pixel's largest difference as an RGB picture by `heat`: `full_scale` steps (or units) and more have
/// the hottest colour; 0 takes the largest difference found. Pixels that `compare` leaves out as non-finite
/// are green, masked ones and background coldest. Errors as `compare`.
Image8 heatmap(const Image8& reference, const Image8& image, double full_scale = 0,
               const Image8* mask = nullptr);
Image8 heatmap(const ImageF& reference, const ImageF& image, Unit unit, double full_scale = 0,
               const Image8* mask = nullptr);

}  // namespace texel::image
