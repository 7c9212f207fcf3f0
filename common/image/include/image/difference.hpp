// SPDX-License-Identifier: MIT
#pragma once
#include <limits>
#include <vector>

#include "image/image.hpp"

namespace texel::image {

/// How far one picture is from another.
struct Difference {
  int width = 0;      ///< pixels
  int height = 0;     ///< pixels
  double max = 0;     ///< the largest difference
  double mean = 0;    ///< the mean over samples (over pixels for directions and texture coordinates)
  double p99 = 0;     ///< the 99th percentile over pixels of each pixel's largest difference
  double p999 = 0;    ///< and the 99.9th
  int telling_x = 0;  ///< the pixel whose difference is p999, or Comparing::told, from the lower left corner
  int telling_y = 0;
  long long non_finite = 0;  ///< pixels with NaN or infinity in either picture: in none of the figures above
  long long forgiven = 0;    ///< pixels whose difference a tolerance made smaller
  /// Each pixel's largest difference: NaN where it is not finite, 0 where it is left out.
  std::vector<double> pixels = {};
};

/// What pictures are compared by. Both float and 8-bit pictures take the first two.
struct Comparing {
  /// Only pixels whose first channel here is above 0 count. It has the pictures' size.
  const Image8* mask = nullptr;

  /// Allows an edge to lie one pixel off, as between two right renderers. A pixel then counts with the
  /// smallest difference to any of the 3x3 pixels around it in the other picture, taken from either picture;
  /// the worse of the two. An edge is where in either picture the pixel differs from one of its neighbours
  /// by more than an eighth of the whole range, which is 32 8-bit levels, 22.5 degrees, or an eighth of the
  /// spread of the finite values. Only differences of more than half that much are forgiven, and none when
  /// they are more than a tenth of all edge pixels: then the picture was moved.
  bool edge_tolerance = false;

  /// Allows the picture to be moved by this part of a pixel: a difference counts as none that is at most this
  /// part of what the reference's pixel differs from one of the 8 around it. Renderers round a vertex's place
  /// in the window, GPUs to 1/256 of a pixel, and what they interpolate and look up moves with it.
  double moved_pixels = 0;

  /// Of float pictures, R, G and B are a vector of any length: the angle between the two pictures' vectors.
  /// Else they are compared sample by sample, in their own unit.
  bool in_degrees = false;

  /// The pixel is sought whose difference is closest to this; where it is NaN, to p999.
  double told = std::numeric_limits<double>::quiet_NaN();
};

/// Compares R, G and B in 8-bit levels; grey counts as R = G = B, and alpha is ignored. The percentile is the
/// nearest rank: of n pixels sorted upwards the value at rank ceil(0.99 n). Throws Error (exit 3) when the
/// sizes differ or the mask leaves no pixel.
Difference compare(const Image8& reference, const Image8& image, Comparing comparing = {});

/// Compares float pictures. A pixel with NaN or infinity in either picture is counted in `non_finite` and
/// left out. For directions (3 or 4 channels) the angle is atan2(|a x b|, a . b), exact for small angles too;
/// a pixel that is (0, 0, 0) in both is background and left out; in only one picture it is 180 degrees off.
/// When no pixel is left the figures are 0. Throws Error (exit 3) when the sizes or channels differ, or
/// directions have fewer than 3 channels.
Difference compare(const ImageF& reference, const ImageF& image, const Comparing& comparing = {});

/// Each pixel's largest difference as an RGB picture by `heat`: `full_scale` levels (or units) and more have
/// the hottest colour; 0 takes the largest difference found. Pixels that are not finite are green, masked
/// ones and background coldest.
Image8 heatmap(const Difference& difference, double full_scale = 0);

}  // namespace texel::image
