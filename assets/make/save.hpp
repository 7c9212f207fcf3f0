// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "image/image.hpp"

namespace texel::assets {

inline constexpr int best_compression = 9;  ///< of zlib: these files are written once and cloned often

/// A 16-bit grey PNG. Throws Error (exit 3) when it cannot be written.
void save_png16(const std::filesystem::path& path, const image::Image16& picture);

}  // namespace texel::assets
