// SPDX-License-Identifier: MIT
#include "guards.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace texel::image {
namespace {

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

/// Calls `visit(marker, content, end)` with each segment of a JPEG that has a length (T.81, B.1.1.4), up to
/// the picture's end: a stamp or a phone's second picture or film may follow.
template <class Visit>
void for_each_segment(std::string_view bytes, Visit visit) {
  const Bytes jpeg{bytes};
  std::size_t at = 0;
  while (is_jpeg(bytes) && (at = bytes.find('\xff', at)) != std::string_view::npos) {
    while (jpeg[at] == 0xff) ++at;
    const std::size_t marker = jpeg[at++];
    if (marker == 0xd9) return;
    // A zero is an escaped 0xff among the samples; 0xd0 to 0xd8 and 1 stand alone; all others have a length.
    if (marker <= 1 || (marker >= 0xd0 && marker <= 0xd8)) continue;
    const std::size_t content = at + 2;
    at += std::max<std::size_t>(jpeg.big_endian16(at), 2);
    visit(marker, content, at);
  }
}

/// The orientation in an Exif block (CIPA DC-008, 4.6.4) that begins at `tiff`, or 1.
int exif_orientation(const Bytes& exif, std::size_t tiff) {
  const bool is_little = exif[tiff] == 'I';
  const auto number = [&](std::size_t at) {
    return is_little ? exif.little_endian16(tiff + at) : exif.big_endian16(tiff + at);
  };
  const std::size_t directory = number(is_little ? 4 : 6);  // within 64 KiB, as the whole block is
  for (std::size_t i = 0; i < number(directory); ++i) {
    const std::size_t entry = directory + 2 + 12 * i, value = number(entry + 8);
    if (number(entry) == 0x112 && value >= 1 && value <= 8) return static_cast<int>(value);
  }
  return 1;
}

/// Only the first bytes tell a TGA: whether it has a palette, and its kind.
bool is_tga(const Bytes& tga) {
  return tga[1] <= 1 && (tga[2] & 7U) >= 1 && (tga[2] & 7U) <= 3 && tga[2] < 16;
}

std::size_t tga_palette_bytes(const Bytes& tga) {
  return tga[1] == 1 ? tga.little_endian16(5) * ((tga[7] + 7) / 8) : 0;
}
constexpr std::size_t tga_header_size = 18;

}  // namespace

std::string damaged_png_chunk(std::string_view bytes) {
  if (!bytes.starts_with(png_signature)) return {};
  const Bytes png{bytes};
  for (std::size_t at = png_signature.size(); at + 12 <= bytes.size();) {
    const std::size_t length = png.big_endian32(at);
    if (length > bytes.size() - at - 12) break;
    const std::string_view type = bytes.substr(at + 4, 4);
    const bool read = type == "IHDR" || type == "PLTE" || type == "tRNS" || type == "IDAT";
    if (read && crc32(bytes.substr(at + 4, length + 4)) != png.big_endian32(at + 8 + length))
      return std::string(type);
    if (type == "IEND") break;
    at += length + 12;
  }
  return {};
}

std::string jpeg_fault(std::string_view bytes) {
  const Bytes jpeg{bytes};
  std::string fault;
  bool is_adobe = false, has_four = false;
  for_each_segment(bytes, [&](std::size_t marker, std::size_t at, std::size_t end) {
    const bool is_frame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    is_adobe |= marker == 0xee && bytes.substr(std::min(at, bytes.size())).starts_with("Adobe");
    has_four |= is_frame && jpeg[at + 5] == 4;
    if (!fault.empty()) return;
    if (marker == 0xc4 && huffman_tables_overrun(jpeg, at, end)) fault = "has invalid JPEG tables";
    if (!is_frame) return;
    if (marker >= 0xc9)
      fault = "is a JPEG with arithmetic coding, which is not read";
    else if (marker == 0xc3)
      fault = "is a lossless JPEG, which is not read";
    else if (marker > 0xc3)
      fault = "is a hierarchical JPEG, which is not read";
    else if (jpeg[at] != 8)
      fault = "is a JPEG of " + std::to_string(jpeg[at]) + " bits a sample, which is not read";
    else if (sampling_overruns(jpeg, at))
      fault = "has invalid JPEG tables";
  });
  if (fault.empty() && has_four && !is_adobe)
    fault = "is a JPEG of four channels that does not say what they are (Adobe's marker is missing)";
  return fault;
}

int orientation(std::string_view bytes) {
  int found = 1;
  for_each_segment(bytes, [&](std::size_t marker, std::size_t at, std::size_t) {
    constexpr std::string_view exif("Exif\0\0", 6);
    if (found == 1 && marker == 0xe1 && bytes.substr(std::min(at, bytes.size())).starts_with(exif))
      found = exif_orientation({bytes}, at + exif.size());
  });
  return is_tga({bytes}) && (Bytes{bytes}[17] & 0x10U) != 0 ? 2 : found;
}

void make_tga_plain(std::string& bytes) {
  const Bytes tga{bytes};
  if (!is_tga(tga) || tga[1] != 1 || bytes.size() < tga_header_size + tga[0] + tga_palette_bytes(tga)) return;
  const std::size_t palette = tga_header_size + tga[0], first = tga.little_endian16(3),
                    last = first + tga.little_endian16(5);
  if ((tga[2] & 7U) == 1) {
    if (last > 0xffff) return;
    bytes.insert(palette, first * ((tga[7] + 7) / 8), '\0');
    bytes[5] = static_cast<char>(last & 0xffU), bytes[6] = static_cast<char>(last >> 8U);
    bytes[3] = bytes[4] = 0;
  } else {
    bytes.erase(palette, tga_palette_bytes(tga));
    bytes[1] = 0;
  }
}

std::string other_format(std::string_view bytes) {
  struct Format {
    std::size_t at;
    std::string_view start;
    const char* name;
  };
  using namespace std::string_view_literals;
  static constexpr Format formats[] = {
      {8, "WEBP", "a WebP file"},
      {4, "ftypavi", "an AVIF file"},
      {4, "ftyphe", "a HEIC file"},
      {4, "ftypm", "a HEIC or AVIF file, or a film"},
      {4, "ftyp", "a film"},
      {0, "II*\0"sv, "a TIFF file"},
      {0, "MM\0*"sv, "a TIFF file"},
      {0, "\xabKTX", "a KTX file"},
      {0, "DDS ", "a DDS file"},
      {0, "#?R", "a Radiance HDR file"},
      {0, "v/1\1", "an OpenEXR file"},
      {0, "8BPS", "a Photoshop file"},
      {0, "gimp xcf", "a GIMP file"},
      {4, "jP  ", "a JPEG 2000 file"},
      {0, "\xff\x4f\xff\x51", "a JPEG 2000 file"},
      {4, "JXL ", "a JPEG XL file"},
      {0, "\xff\x0a", "a JPEG XL file"},
      {0, "P1", "a PBM file"},
      {0, "P2", "a PGM file"},
      {0, "P3", "a PPM file"},
      {0, "P4", "a PBM file"},
      {0, "P5", "a PGM file"},
      {0, "P6", "a PPM file"},
      {0, "P7", "a PAM file"},
      {0, "PF", "a PFM file"},
      {0, "Pf", "a PFM file"},
      {0, "qoif", "a QOI file"},
      {0, "\0\0\1\0"sv, "an icon file"},
      {0, "\x0a\5\1", "a PCX file"},
      {0, "\1\xda", "an SGI file"},
      {0, "%PDF", "a PDF file"},
      {0, "<svg", "an SVG file"},
      {0, "<", "a file of text"},
      {0, "version https://git-lfs", "Git LFS's pointer to a file"},
  };
  for (const Format& format : formats)
    if (bytes.size() > format.at && bytes.substr(format.at).starts_with(format.start)) return format.name;
  const std::size_t compression = Bytes{bytes}[30];
  if (bytes.starts_with("BM") && (compression == 1 || compression == 2))
    return "a run-length-encoded BMP file";
  if (bytes.ends_with("TRUEVISION-XFILE.\0"sv)) return "a TGA file of an unusual kind";
  return {};
}

std::string tga_fault(std::string_view bytes, std::size_t pixels) {
  const Bytes tga{bytes};
  if (!is_tga(tga)) return {};
  if ((tga[17] & 0xc0U) != 0) return "is a TGA file with interleaved rows, which is not read";
  const std::size_t size = tga_header_size + tga[0] + tga_palette_bytes(tga) + pixels * ((tga[16] + 7) / 8);
  const bool run_length_encoded = tga[2] > 3;
  return run_length_encoded || bytes.size() >= size ? "" : "is cut short";
}

}  // namespace texel::image
