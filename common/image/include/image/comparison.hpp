// SPDX-License-Identifier: MIT
// What all comparisons of two pictures share.
#pragma once
#include <fmt/format.h>

#include <cstddef>

#include "core/error.hpp"
#include "image/image.hpp"

namespace texel::image {

/// Throws Error (exit 3) when the sizes of two pictures, or of a picture and its mask, differ.
template <class Sample, class Other>
void check_sizes(const Image<Sample>& reference, const Image<Other>& image, const Image8* mask) {
  const auto same = [&](const auto& other) {
    return other.width == reference.width && other.height == reference.height;
  };
  if (!same(image))
    throw Error::failed(fmt::format("the pictures differ in size: {}x{} and {}x{}", reference.width,
                                    reference.height, image.width, image.height),
                        {}, "draw both in the same size");
  if (mask && !same(*mask))
    throw Error::failed(fmt::format("the mask is {}x{}, the pictures {}x{}", mask->width, mask->height,
                                    reference.width, reference.height),
                        {}, "give a mask of the pictures' size");
}

/// Whether the mask, if there is one, lets this pixel through.
inline bool counts(const Image8* mask, int x, int y) {
  return !mask || mask->at(x, y) > 0;
}

/// Throws Error (exit 3) for a comparison that is left without a pixel.
inline void check_any(bool any) {
  if (!any)
    throw Error::failed("there is no pixel to compare", {},
                        "give pictures with pixels and a mask with light ones");
}

/// R, G or B of a pixel; grey is R = G = B.
inline std::uint8_t rgb_sample(const Image8& picture, int x, int y, int c) {
  return picture.at(x, y, picture.channels < 3 ? 0 : c);
}

/// Where a percentile stands among `count` values sorted upwards, at least one, counted from 0: the nearest
/// rank, ceil(count * per_mille / 1000) counted from 1.
inline std::size_t index_of_per_mille(std::size_t count, std::size_t per_mille) {
  return (per_mille * count + 999) / 1000 - 1;
}

}  // namespace texel::image
