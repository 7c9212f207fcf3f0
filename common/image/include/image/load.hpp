// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "image/image.hpp"

namespace texel::image {

/// What a picture's header says.
struct Info {
  int width = 0;     ///< pixels
  int height = 0;    ///< pixels
  int channels = 0;  ///< 1 to 4, as stored (a PNG's single transparent colour adds alpha only when loaded)
  bool is_16_bit = false;
};

/// Reads the header of a PNG, JPEG, GIF, BMP or TGA file. The limits are 16384 pixels a side and 2^28
/// samples. Throws Error (exit 3) that names the file when it is missing, not one of these formats or beyond
/// the limits.
Info info(const std::filesystem::path& path);

/// Loads a PNG, JPEG, GIF (its first frame), BMP or TGA file, bottom row first, values as they are encoded.
/// `channels` is 1 to 4, or 0 to keep the file's own; grey becomes RGB by repetition, RGB grey by luma
/// weights, and a missing alpha is opaque. 16-bit samples are rounded to the nearest of 8 bits. A photo is
/// turned as its Exif block says. The limits are checked before anything is allocated. Throws Error (exit 3)
/// that names the file when it is missing, broken, cut short, too large, damaged (a PNG's checksum is wrong)
/// or of another format or variant, which it names.
Image8 load8(const std::filesystem::path& path, int channels = 0);

/// A PNG of exactly this size as RGB, as `load8` gives it (of 16 bits the upper 8), by libspng: it never
/// unpacks more than the size needs, and it checks the file's checksums. For pictures that strangers made.
/// Throws Error (exit 3) with `name` for any other size, and when it is broken or cut short.
Image8 parse_png(std::string_view bytes, const std::string& name, int width, int height);

/// A portable float map, `PF` (3 channels) or `Pf` (1), of either byte order, bottom row first as the format
/// has it. NaN and infinity are kept; the header's scale gives the byte order only. Limits and errors as for
/// `load8`, with `name`. Source: P. Debevec, http://www.pauldebevec.com/Research/HDR/PFM/
ImageF parse_pfm(std::string_view bytes, const std::string& name);
ImageF load_pfm(const std::filesystem::path& path);

}  // namespace texel::image
