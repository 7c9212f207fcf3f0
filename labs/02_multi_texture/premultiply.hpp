// SPDX-License-Identifier: MIT
#pragma once
#include "image/color.hpp"

namespace texel::multi_texture {

/// Colour times alpha, multiplied in linear light: a transparent texel then adds nothing to an average.
inline image::Image8 premultiplied(image::Image8 picture) {
  if (picture.channels != 4) return picture;  // opaque
  for (std::size_t i = 0; i < picture.samples.size(); i += 4) {
    const float alpha = static_cast<float>(picture.samples[i + 3]) / 255.0F;
    for (std::size_t c = i; c < i + 3; ++c)
      picture.samples[c] = image::to_encoding8(alpha * image::from_encoding8(picture.samples[c]));
  }
  return picture;
}

}  // namespace texel::multi_texture
