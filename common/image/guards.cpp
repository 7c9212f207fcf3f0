// SPDX-License-Identifier: MIT
#include "guards.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace texel::image {
namespace {

/// The file's bytes as numbers, zeros beyond its end as stb_image reads them.
struct Bytes {
  std::string_view bytes;
  std::size_t operator[](std::size_t at) const {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
  }
  [[nodiscard]] std::size_t big_endian16(std::size_t at) const { return (*this)[at] << 8 | (*this)[at + 1]; }
};

/// A JPEG begins with the marker 0xd8; any number of 0xff may stand before a marker.
bool is_jpeg(std::string_view bytes) {
  const std::size_t marker = bytes.find_first_not_of('\xff');
  return marker != 0 && marker != std::string_view::npos && bytes[marker] == '\xd8';
}

/// DHT (ITU-T T.81, B.2.4.2): tables of one byte, 16 counts and as many values as the counts say.
bool huffman_tables_overrun(const Bytes& jpeg, std::size_t at, std::size_t end) {
  while (at < end) {
    std::size_t codes = 0;
    for (std::size_t i = 1; i <= 16; ++i) codes += jpeg[at + i];
    if (codes > 256) return true;
    at += 17 + codes;
  }
  return false;
}

/// SOF (B.2.2): each component's horizontal and vertical factor in the two halves of a byte.
bool sampling_overruns(const Bytes& jpeg, std::size_t at) {
  const std::size_t components = std::min<std::size_t>(jpeg[at + 5], 4);
  for (const unsigned shift : {4U, 0U}) {
    const auto factor = [&](std::size_t component) { return jpeg[at + 7 + 3 * component] >> shift & 15; };
    std::size_t largest = 1;
    for (std::size_t i = 0; i < components; ++i) largest = std::max(largest, factor(i));
    for (std::size_t i = 0; i < components; ++i)
      if (factor(i) == 0 || largest % factor(i) != 0) return true;
  }
  return false;
}

constexpr std::array<std::uint32_t, 256> crc_table = [] {
  std::array<std::uint32_t, 256> table{};
  for (std::uint32_t i = 0; i < 256; ++i) {
    table[i] = i;
    for (int bit = 0; bit < 8; ++bit) table[i] = table[i] >> 1U ^ ((table[i] & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return table;
}();

std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char c : bytes) crc = crc >> 8U ^ crc_table[(crc ^ static_cast<unsigned char>(c)) & 0xffU];
  return ~crc;
}

}  // namespace

std::string damaged_png_chunk(std::string_view bytes) {
  constexpr std::string_view signature("\x89PNG\r\n\x1a\n");
  if (!bytes.starts_with(signature)) return {};
  const Bytes png{bytes};
  const auto big_endian32 = [&](std::size_t at) {
    return png.big_endian16(at) << 16U | png.big_endian16(at + 2);
  };
  for (std::size_t at = signature.size(); at + 12 <= bytes.size();) {
    const std::size_t length = big_endian32(at);
    if (length > bytes.size() - at - 12) break;
    const std::string_view type = bytes.substr(at + 4, 4);
    const bool read = type == "IHDR" || type == "PLTE" || type == "tRNS" || type == "IDAT";
    if (read && crc32(bytes.substr(at + 4, length + 4)) != big_endian32(at + 8 + length))
      return std::string(type);
    at += length + 12;
  }
  return {};
}

bool jpeg_overruns(std::string_view bytes) {
  if (!is_jpeg(bytes)) return false;
  const Bytes jpeg{bytes};
  std::size_t at = 0;
  while ((at = bytes.find('\xff', at)) != std::string_view::npos) {
    while (jpeg[at] == 0xff) ++at;
    const std::size_t marker = jpeg[at++];
    // A zero is an escaped 0xff among the samples; 0xd0 to 0xd9 and 1 stand alone; all others have a length.
    if (marker <= 1 || (marker >= 0xd0 && marker <= 0xd9)) continue;
    const std::size_t content = at + 2;
    at += std::max<std::size_t>(jpeg.big_endian16(at), 2);
    if (marker == 0xc4 && huffman_tables_overrun(jpeg, content, at)) return true;
    if (marker >= 0xc0 && marker <= 0xc2 && sampling_overruns(jpeg, content)) return true;
  }
  return false;
}

bool tga_is_cut_short(std::string_view bytes, std::size_t pixels) {
  constexpr std::size_t header_size = 18;
  const Bytes tga{bytes};
  const bool other_format =
      bytes.starts_with("\x89PNG") || bytes.starts_with("BM") || bytes.starts_with("GIF8") || is_jpeg(bytes);
  const bool run_length_encoded = tga[2] > 3;
  if (other_format || run_length_encoded) return false;
  const std::size_t palette = tga[1] == 1 ? (tga[5] + 256 * tga[6]) * ((tga[7] + 7) / 8) : 0;
  return bytes.size() < header_size + tga[0] + palette + pixels * ((tga[16] + 7) / 8);
}

}  // namespace texel::image
