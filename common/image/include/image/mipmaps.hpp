// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "image/image.hpp"

namespace texel::image {

/// All levels of a picture, from itself down to 1x1, each side halved and rounded down as OpenGL has it. A
/// texel averages exactly the area that it covers on the level above, with fractional weights where a side is
/// odd ("polyphase box", N. Guertin, "Non-power-of-two mipmapping", NVIDIA 2005). Levels are rounded to 8
/// bits only when they are stored, not on the way. With `Encoding::srgb` colour is averaged in linear light
/// and alpha (the last of 2 or 4 channels) without decoding. Alpha is straight and does not weight the
/// colour, as in glGenerateMipmap and in samplers. If transparent texels must not bleed, premultiply first.
std::vector<Image8> mip_chain(const Image8& image, Encoding encoding);

}  // namespace texel::image
