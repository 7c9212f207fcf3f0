// SPDX-License-Identifier: MIT
#pragma once
#include <fmt/format.h>

#include <filesystem>

#include "core/error.hpp"
#include "image/image.hpp"

namespace texel::image {

/// Throws Error (exit 3) unless the picture can be a file.
template <class Sample>
void check_not_empty(const std::filesystem::path& path, const Image<Sample>& image) {
  if (image.width < 1 || image.height < 1 || image.channels < 1 || image.channels > 4)
    throw Error::failed(
        fmt::format("cannot write {}x{} pixels of {} channels", image.width, image.height, image.channels),
        {path.string()}, "use a picture of at least 1x1 pixels with 1 to 4 channels");
}

}  // namespace texel::image
