// SPDX-License-Identifier: MIT
// What stb_image does not look at itself.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace texel::image {

/// Whether a JPEG file would make stb_image write or read beyond its tables: a Huffman table of more than 256
/// codes, or sampling factors that do not divide the largest one. Version 2.28 refuses both, Debian 12
/// has 2.27 (https://github.com/nothings/stb/pull/1297).
bool jpeg_overruns(std::string_view bytes);

/// Whether a TGA file that is not run-length encoded has too few bytes for its `pixels`: stb_image would give
/// what happens to be in memory for the last row. False for files of other formats.
bool tga_is_cut_short(std::string_view bytes, std::size_t pixels);

/// The chunk of a PNG file, such as "IDAT", that is damaged: its checksum is wrong (PNG specification, 5.3
/// and annex D), which stb_image does not ask. Only the chunks that make the picture are looked at, up to
/// where the file is cut short; "" where all are sound and for files of other formats.
std::string damaged_png_chunk(std::string_view bytes);

}  // namespace texel::image
