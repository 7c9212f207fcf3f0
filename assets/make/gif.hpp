// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "image/image.hpp"

namespace texel::assets {

/// An RGB picture of at least 256 pixels as a GIF of 256 colours, which median cut chooses. Its codes are
/// stored, not compressed. Sources: GIF89a specification (CompuServe, 1990); Heckbert, Color Image
/// Quantization (1982).
void save_gif(const std::filesystem::path& path, const image::Image8& picture);

}  // namespace texel::assets
