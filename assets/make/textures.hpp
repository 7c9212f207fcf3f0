// SPDX-License-Identifier: MIT
#pragma once
#include "progress.hpp"

namespace texel::assets {

/// Writes folder/textures: the colour pictures, and the small hard cases of image loading.
void make_textures(const std::filesystem::path& folder, const Progress& progress);

/// Writes folder/normal_maps: 8 bits, +y up, linear, n = 2c - 1, exact at every texel's middle.
void make_normal_maps(const std::filesystem::path& folder, const Progress& progress);

}  // namespace texel::assets
