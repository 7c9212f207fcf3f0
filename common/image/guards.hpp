// SPDX-License-Identifier: MIT
// What stb_image does not look at itself.
#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace texel::image {

/// A file's bytes as numbers, zeros beyond its end as stb_image reads them.
struct Bytes {
  std::string_view bytes;

  std::size_t operator[](std::size_t at) const {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
  }
  [[nodiscard]] std::size_t big_endian16(std::size_t at) const { return (*this)[at] << 8 | (*this)[at + 1]; }
  [[nodiscard]] std::size_t big_endian32(std::size_t at) const {
    return big_endian16(at) << 16U | big_endian16(at + 2);
  }
  [[nodiscard]] std::size_t little_endian16(std::size_t at) const {
    return (*this)[at] | (*this)[at + 1] << 8;
  }
};

inline constexpr std::string_view png_signature = "\x89PNG\r\n\x1a\n";

/// What is wrong with a JPEG file, or "": a variant that stb_image does not read, or reads in wrong colours;
/// or tables beyond which it would write or read, a Huffman table of more than 256 codes and sampling factors
/// that do not divide the largest one. Version 2.28 refuses these two, Debian 12 has 2.27
/// (https://github.com/nothings/stb/pull/1297).
std::string jpeg_fault(std::string_view bytes);

/// How a picture is to be turned, as Exif numbers it (CIPA DC-008, 4.6.4): 1 as it is, 2 to 8 mirrored,
/// turned by quarters, or both. By the Exif block of a JPEG, and the order of columns of a TGA.
int orientation(std::string_view bytes);

/// Makes a TGA with a palette one that stb_image reads: its palette begins at 0, and of a picture that does
/// not use its palette there is none. Other files stay.
void make_tga_plain(std::string& bytes);

/// What is wrong with a TGA file of so many `pixels`, or "": a variant that stb_image reads wrongly; or too
/// few bytes where it is not run-length encoded, when stb_image would give what happens to be in memory for
/// the last row.
std::string tga_fault(std::string_view bytes, std::size_t pixels);

/// What a file is that cannot be read, as "a WebP file", or "" where nothing tells.
std::string other_format(std::string_view bytes);

/// The chunk of a PNG file, such as "IDAT", that is damaged: its checksum is wrong (PNG specification, 5.3
/// and annex D), which stb_image does not ask. Only the chunks that make the picture are looked at, up to
/// where the file is cut short; "" where all are sound and for files of other formats.
std::string damaged_png_chunk(std::string_view bytes);

}  // namespace texel::image
