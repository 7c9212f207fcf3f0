// SPDX-License-Identifier: MIT
// What stb_image does not look at itself.
#pragma once
#include <cstddef>
#include <string_view>

namespace texel::image {

/// Whether a JPEG file would make stb_image write or read beyond its tables: a Huffman table of more than 256
/// codes, or sampling factors that do not divide the largest one. Version 2.28 refuses both, Debian 12
/// has 2.27 (https://github.com/nothings/stb/pull/1297).
bool jpeg_overruns(std::string_view bytes);

/// Whether a TGA file that is not run-length encoded has too few bytes for its `pixels`: stb_image would give
/// what happens to be in memory for the last row. False for files of other formats.
bool tga_is_cut_short(std::string_view bytes, std::size_t pixels);

}  // namespace texel::image
