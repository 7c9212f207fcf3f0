// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "image/image.hpp"

namespace texel::image {

/// Loads a PNG, JPEG, GIF (its first frame), BMP or TGA file, bottom row first, values as they are encoded.
/// `channels` is 3, when grey becomes RGB by repetition and alpha is left out, or 0 to keep the file's own.
/// 16 bits are rounded to the nearest of 8. A photo is turned as its Exif block says. The limits, 16384
/// pixels a side and 2^28 samples, are checked before anything is allocated. Throws Error (exit 3) that names
/// the file when it is missing, broken, cut short, too large, damaged (a PNG's checksum is wrong) or of
/// another format or variant, which it names.
Image8 load8(const std::filesystem::path& path, int channels = 0);

struct Size {
  int width = 0, height = 0;  ///< pixels
};

/// By the header of a PNG, and within the limits. Throws Error (exit 3) with `name`.
Size png_size(std::string_view bytes, const std::string& name);

/// A PNG of exactly this size as RGB, as `load8` gives it. It never unpacks more than the size needs: for
/// pictures that strangers made. Throws Error (exit 3) with `name` for any other size, and when it is broken
/// or cut short.
Image8 parse_png(std::string_view bytes, const std::string& name, int width, int height);

/// A portable float map, `PF` (3 channels) or `Pf` (1), of either byte order, bottom row first as the format
/// has it. NaN and infinity are kept; the header's scale gives the byte order only. Limits and errors as for
/// `load8`, with `name`. Source: P. Debevec, http://www.pauldebevec.com/Research/HDR/PFM/
ImageF parse_pfm(std::string_view bytes, const std::string& name);
ImageF load_pfm(const std::filesystem::path& path);

}  // namespace texel::image
