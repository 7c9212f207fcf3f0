// SPDX-License-Identifier: MIT
// Tiny picture files made byte by byte, for the tests of what we do not write ourselves.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <string>

#include "core/files.hpp"

namespace texel::test {

/// A new empty folder, gone at the end, which all users of the machine may enter.
class TemporaryFolder : public ScratchFolder {
 public:
  TemporaryFolder() { std::filesystem::permissions(path(), std::filesystem::perms(0755)); }
  [[nodiscard]] std::filesystem::path operator/(const std::string& file) const { return path() / file; }
  [[nodiscard]] bool empty() const { return std::filesystem::is_empty(path()); }
};

/// Writes these files below a folder, with the folders that they lie in.
inline void put(const std::filesystem::path& root, const std::map<std::string, std::string>& files) {
  for (const auto& [file, text] : files) {
    std::filesystem::create_directories((root / file).parent_path());
    write_file(root / file, text);
  }
}

inline std::string bytes(std::initializer_list<int> values) {
  std::string result;
  for (const int value : values) result += static_cast<char>(value);
  return result;
}

inline std::string big_endian(std::uint32_t value) {
  std::string result;
  for (int shift = 24; shift >= 0; shift -= 8) result += static_cast<char>(value >> shift & 0xffU);
  return result;
}

/// A PNG chunk with its CRC (PNG specification, annex D).
inline std::string png_chunk(const std::string& type, const std::string& data) {
  std::uint32_t crc = 0xffffffffU;
  for (const char c : type + data) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
  }
  return big_endian(static_cast<std::uint32_t>(data.size())) + type + data + big_endian(~crc);
}

/// A PNG of any kind from its filtered rows (at most 65535 bytes), stored unpacked.
inline std::string png(std::uint32_t width, std::uint32_t height, int bits, int color_type,
                       const std::string& rows) {
  const std::string header = big_endian(width) + big_endian(height) + bytes({bits, color_type, 0, 0, 0});
  const auto size = static_cast<int>(rows.size());
  std::uint32_t a = 1;
  std::uint32_t b = 0;
  for (const char c : rows) {
    a = (a + static_cast<unsigned char>(c)) % 65521;
    b = (b + a) % 65521;
  }
  const std::string zlib = bytes({0x78, 0x01, 0x01, size & 255, size >> 8, ~size & 255, ~size >> 8 & 255}) +
                           rows + big_endian(b << 16 | a);
  return bytes({0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'}) + png_chunk("IHDR", header) +
         png_chunk("IDAT", zlib) + png_chunk("IEND", "");
}

/// 2x2 pixels, bottom row red and green, top row blue and white, in each of the formats that have colour.
inline std::string bmp_2x2() {
  return bytes({'B', 'M', 70, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0}) +  // file header
         bytes({40, 0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 1, 0, 24, 0, 0, 0, 0, 0, 16, 0, 0, 0}) +
         bytes({0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}) +
         bytes({0, 0, 255, 0, 255, 0, 0, 0}) +  // blue, green, red; rows are filled up to 4 bytes
         bytes({255, 0, 0, 255, 255, 255, 0, 0});
}

inline std::string tga_2x2() {
  return bytes({0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, 0}) +
         bytes({0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255});
}

/// The same, run-length encoded and top row first: two runs of one pixel, then a packet of two.
inline std::string tga_rle_2x2() {
  return bytes({0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 2, 0, 24, 0x20}) +
         bytes({0x80, 255, 0, 0, 0x80, 255, 255, 255, 0x01, 0, 0, 255, 0, 255, 0});
}

/// One GIF frame of 2x2 palette entries 0 to 3: LZW codes of 3 bits, cleared (4) before they would grow,
/// ended by 5.
inline std::string gif_frame(std::array<unsigned, 4> pixels) {
  const std::array<unsigned, 7> codes = {4, pixels[0], pixels[1], 4, pixels[2], pixels[3], 5};
  unsigned packed = 0;
  for (std::size_t i = 0; i < codes.size(); ++i) packed |= codes[i] << (3 * i);
  return bytes({0x2c, 0, 0, 0, 0, 2, 0, 2, 0, 0, 2, 3, static_cast<int>(packed & 255),
                static_cast<int>(packed >> 8 & 255), static_cast<int>(packed >> 16), 0});
}

/// The same picture, and a second frame that is all white.
inline std::string gif_2x2() {
  return "GIF89a" + bytes({2, 0, 2, 0, 0x81, 0, 0}) +
         bytes({255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}) + gif_frame({2, 3, 0, 1}) +
         gif_frame({3, 3, 3, 3}) + ";";
}

/// 8x8 grey pixels of value 100: one block of a JPEG that has only its first coefficient.
inline std::string jpeg_8x8() {
  const std::string quantisation(64, '\1');
  return bytes({0xff, 0xd8, 0xff, 0xdb, 0, 67, 0}) + quantisation +
         bytes({0xff, 0xc0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0}) +  // 8 bits, 8x8, one component
         // The first coefficient's code 0 means 8 bits, the others' code 0 means "no more".
         bytes({0xff, 0xc4, 0, 20, 0x00, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 8}) +
         bytes({0xff, 0xc4, 0, 20, 0x10, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}) +
         // 8 (100 - 128) = -224 is 255 - 224 = 31 in 8 bits: 0 00011111 0 and ones to fill.
         bytes({0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0, 0x0f, 0xbf, 0xff, 0xd9});
}

/// 24x16 grey pixels, six blocks of 144, 169, 138 in the upper half and 158, 176, 159 in the lower one, as a
/// camera that was held in that way writes it.
inline std::string jpeg_of_camera(int orientation, bool little_endian) {
  const std::string one = jpeg_8x8();
  const std::string directory =
      little_endian ? "II" + bytes({42, 0, 8, 0, 0, 0, 2, 0, 0, 1, 3, 0, 1, 0, 0, 0, 24, 0, 0, 0}) +
                          bytes({0x12, 1, 3, 0, 1, 0, 0, 0, orientation, 0, 0, 0, 0, 0, 0, 0})
                    : "MM" + bytes({0, 42, 0, 0, 0, 8, 0, 2, 1, 0, 0, 3, 0, 0, 0, 1, 0, 24, 0, 0}) +
                          bytes({1, 0x12, 0, 3, 0, 0, 0, 1, 0, orientation, 0, 0, 0, 0, 0, 0});
  const std::string exif = "Exif" + bytes({0, 0}) + directory + one;  // with a small picture inside
  const std::size_t frame = one.find(bytes({8, 0, 8, 0, 8})), samples = one.size() - 4;
  return one.substr(0, 2) + bytes({0xff, 0xe1, 0, static_cast<int>(exif.size()) + 2}) + exif +
         one.substr(2, frame - 2) + bytes({8, 0, 16, 0, 24}) + one.substr(frame + 5, samples - frame - 5) +
         // The change of the first coefficient to the next block is that of the grey, eight times.
         bytes({0x40, 0x19, 0x0, 0x39, 0x40, 0x48, 0xe, 0xef, 0xff, 0xd9});
}

/// 16x16 pixels of grey 128 in three components, the colours at half the size: all coefficients are zero.
inline std::string jpeg_16x16(bool progressive) {
  const std::string quantisation(64, '\1');
  const auto scan = [](std::initializer_list<int> header, std::initializer_list<int> codes) {
    return bytes({0xff, 0xda}) + bytes(header) + bytes(codes);
  };
  std::string result = bytes({0xff, 0xd8, 0xff, 0xdb, 0, 67, 0}) + quantisation +
                       bytes({0xff, progressive ? 0xc2 : 0xc0, 0, 17, 8, 0, 16, 0, 16, 3}) +
                       bytes({1, 0x22, 0, 2, 0x11, 0, 3, 0x11, 0}) +
                       // Both tables have one code, 0, which means "zero" and "no more".
                       bytes({0xff, 0xc4, 0, 20, 0x00, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}) +
                       bytes({0xff, 0xc4, 0, 20, 0x10, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});
  if (!progressive) {
    result += scan({0, 12, 3, 1, 0, 2, 0, 3, 0, 0, 63, 0}, {0x00, 0x0f});  // 6 blocks of two codes
  } else {
    result += scan({0, 12, 3, 1, 0, 2, 0, 3, 0, 0, 0, 0}, {0x03});  // first coefficients: 6 codes
    result += scan({0, 8, 1, 1, 0, 1, 63, 0}, {0x0f});              // the others of 4 blocks, of 1 and of 1
    result += scan({0, 8, 1, 2, 0, 1, 63, 0}, {0x7f});
    result += scan({0, 8, 1, 3, 0, 1, 63, 0}, {0x7f});
  }
  return result + bytes({0xff, 0xd9});
}

}  // namespace texel::test
