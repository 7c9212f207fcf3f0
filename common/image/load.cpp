// SPDX-License-Identifier: MIT
// JPEG, GIF, BMP and TGA by stb_image, and what it does not look at itself.
#include "image/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "core/files.hpp"
#include "decode.hpp"

#define STBI_ONLY_GIF
#ifdef __EMSCRIPTEN__  // a page has only the tree's pictures
#define STBI_ONLY_PNG
#define STBI_ONLY_PNM
#else
#define STBI_ONLY_TGA
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#endif
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG
#define STBI_MALLOC(size) std::calloc(size, 1)  // a JPEG may use tables that it never defined
#define STBI_REALLOC(block, size) std::realloc(block, size)
#define STBI_FREE(block) std::free(block)
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>

namespace texel::image {
namespace {

/// A file's bytes as numbers, zeros beyond its end as stb_image reads them.
struct Bytes {
  std::string_view bytes;

  std::size_t operator[](std::size_t at) const {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
  }
  [[nodiscard]] std::size_t big_endian16(std::size_t at) const { return (*this)[at] << 8 | (*this)[at + 1]; }
  [[nodiscard]] std::size_t little_endian16(std::size_t at) const {
    return (*this)[at] | (*this)[at + 1] << 8;
  }
  [[nodiscard]] bool has(std::size_t at, std::string_view text) const {
    return at <= bytes.size() && bytes.substr(at).starts_with(text);
  }
};

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

/// Calls `visit(marker, content, end)` with each segment of a JPEG that has a length (T.81, B.1.1.4), up to
/// the picture's end: a stamp or a phone's second picture or film may follow.
template <class Visit>
void for_each_segment(std::string_view bytes, Visit visit) {
  const Bytes jpeg{bytes};
  // A JPEG begins with the marker 0xd8; any number of 0xff may stand before a marker.
  std::size_t at = bytes.find_first_not_of('\xff');
  if (at == 0 || jpeg[at] != 0xd8) return;
  while ((at = bytes.find('\xff', at)) != std::string_view::npos) {
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

/// What is wrong with a JPEG file, or "": a variant that stb_image does not read, or reads in wrong colours;
/// or tables beyond which it would write or read. Version 2.28 refuses these, Debian 12 has 2.27
/// (https://github.com/nothings/stb/pull/1297).
std::string jpeg_fault(std::string_view bytes) {
  const Bytes jpeg{bytes};
  std::string fault;
  bool is_adobe = false, has_four = false;
  for_each_segment(bytes, [&](std::size_t marker, std::size_t at, std::size_t end) {
    const bool is_frame =
        marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    is_adobe |= marker == 0xee && jpeg.has(at, "Adobe");
    has_four |= is_frame && jpeg[at + 5] == 4;
    if (!fault.empty()) return;
    if (marker == 0xc4 && huffman_tables_overrun(jpeg, at, end)) fault = "has invalid JPEG tables";
    if (!is_frame) return;
    if (marker >= 0xc3)
      fault = "is a lossless or hierarchical JPEG or one with arithmetic coding, which is not read";
    else if (jpeg[at] != 8)
      fault = "is a JPEG of " + std::to_string(jpeg[at]) + " bits a sample, which is not read";
    else if (sampling_overruns(jpeg, at))
      fault = "has invalid JPEG tables";
  });
  if (fault.empty() && has_four && !is_adobe)
    fault = "is a JPEG of four channels that does not say what they are (Adobe's marker is missing)";
  return fault;
}

/// How a photo is to be turned by its Exif block (CIPA DC-008, 4.6.4): 1 as it is, 2 to 8 mirrored, turned by
/// quarters, or both.
int orientation(std::string_view bytes) {
  const Bytes jpeg{bytes};
  std::size_t found = 1;
  for_each_segment(bytes, [&](std::size_t marker, std::size_t at, std::size_t) {
    if (found != 1 || marker != 0xe1 || !jpeg.has(at, std::string_view("Exif\0\0", 6))) return;
    const std::size_t tiff = at + 6;
    const bool is_little = jpeg[tiff] == 'I';
    const auto number = [&](std::size_t offset) {
      return is_little ? jpeg.little_endian16(tiff + offset) : jpeg.big_endian16(tiff + offset);
    };
    const std::size_t directory = number(is_little ? 4 : 6);  // within 64 KiB, as the whole block is
    for (std::size_t i = 0; i < number(directory) && found == 1; ++i) {
      const std::size_t entry = directory + 2 + 12 * i, value = number(entry + 8);
      if (number(entry) == 0x112 && value >= 1 && value <= 8) found = value;
    }
  });
  return static_cast<int>(found);
}

/// What is wrong with a TGA file of so many pixels, or "": a variant that stb_image reads wrongly, or too few
/// bytes where it is not run-length encoded. Only the first bytes tell a TGA: whether it has a palette, and
/// its kind.
std::string tga_fault(std::string_view bytes, std::size_t pixels) {
  const Bytes tga{bytes};
  const std::size_t has_palette = tga[1], kind = tga[2] & 7U;
  if (has_palette > 1 || kind < 1 || kind > 3 || tga[2] >= 16) return {};
  if ((tga[17] & 0xd0U) != 0) return "is a TGA file with interleaved rows or mirrored, which is not read";
  if (has_palette == 1 && tga.little_endian16(3) != 0)
    return "is a TGA file whose palette does not begin at 0, which is not read";
  const std::size_t palette = has_palette * tga.little_endian16(5) * ((tga[7] + 7) / 8);
  const bool run_length_encoded = tga[2] > 3;
  const std::size_t size = 18 + tga[0] + palette + pixels * ((tga[16] + 7) / 8);
  return run_length_encoded || bytes.size() >= size ? "" : "is cut short";
}

/// What a file is that cannot be read, as "a WebP file", or "" where nothing tells.
std::string other_format(std::string_view bytes) {
  struct Format {
    std::size_t at;
    std::string_view start;
    const char* name;
  };
  using namespace std::string_view_literals;
  static constexpr Format formats[] = {{8, "WEBP", "a WebP file"},
                                       {4, "ftyp", "a HEIC, AVIF or MP4 file"},
                                       {4, "JXL ", "a JPEG XL file"},
                                       {0, "II*\0"sv, "a TIFF file"},
                                       {0, "MM\0*"sv, "a TIFF file"},
                                       {0, "%PDF", "a PDF file"},
                                       {0, "\xabKTX", "a KTX file"},
                                       {0, "DDS ", "a DDS file"},
                                       {0, "#?R", "a Radiance HDR file"},
                                       {0, "v/1\1", "an OpenEXR file"},
                                       {0, "<svg", "an SVG file"},
                                       {0, "<", "a file of text"},
                                       {0, "version https://git-lfs", "Git LFS's pointer to a file"}};
  const Bytes file{bytes};
  for (const Format& format : formats)
    if (file.has(format.at, format.start)) return format.name;
  if (file.has(0, "P") && std::string_view("1234567Ff").find(static_cast<char>(file[1])) != bytes.npos)
    return "a PBM, PGM, PPM, PAM or PFM file";
  if (file.has(0, "BM") && (file[30] == 1 || file[30] == 2)) return "a run-length-encoded BMP file";
  if (bytes.ends_with("TRUEVISION-XFILE.\0"sv)) return "a TGA file of an unusual kind";
  return {};
}

/// A file in memory as stb_image's callbacks read it. Unlike its reader from memory, which goes on with
/// zeros, this one notices that the decoder wanted more than there is.
struct Stream {
  std::string_view rest;
  bool cut_short = false;

  static int read(void* user, char* data, int size) {
    Stream& stream = *static_cast<Stream*>(user);
    const std::size_t count = std::min(stream.rest.size(), static_cast<std::size_t>(size));
    stream.cut_short |= count == 0;
    std::memcpy(data, stream.rest.data(), count);
    stream.rest.remove_prefix(count);
    return static_cast<int>(count);
  }
  static void skip(void* user, int count) {  // never negative: it goes back only inside its own buffer
    std::string_view& rest = static_cast<Stream*>(user)->rest;
    rest.remove_prefix(std::min(rest.size(), static_cast<std::size_t>(std::max(count, 0))));
  }
  static int at_end(void* user) { return static_cast<Stream*>(user)->rest.empty() ? 1 : 0; }
};
constexpr stbi_io_callbacks stream_callbacks = {Stream::read, Stream::skip, Stream::at_end};

/// The picture as Exif's `orientation` shows it. Both count rows from the top, as files do, but the result
/// begins with the bottom row.
Image8 turned(const Image8& stored, int orientation) {
  if (orientation == 1) return flipped(stored);
  const bool on_its_side = orientation >= 5;
  const bool mirrored = orientation == 2 || orientation == 3 || orientation >= 7;
  const bool upside_down = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  Image8 image(on_its_side ? stored.height : stored.width, on_its_side ? stored.width : stored.height,
               stored.channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const int down = image.height - 1 - y;
      const int column = on_its_side ? down : x, row = on_its_side ? x : down;
      std::copy_n(&stored.at(mirrored ? stored.width - 1 - column : column,
                             upside_down ? stored.height - 1 - row : row),
                  image.channels, &image.at(x, y));
    }
  return image;
}

/// A file of any of the other formats.
Image8 decode(std::string_view bytes, const std::string& name, int channels) {
  if (const std::string fault = jpeg_fault(bytes); !fault.empty()) throw broken(name, fault);
  int width = 0, height = 0, stored_channels = 0;
  Stream header{bytes};
  if (stbi_info_from_callbacks(&stream_callbacks, &header, &width, &height, &stored_channels) == 0) {
    const std::string other = other_format(bytes);
    throw broken(name, other.empty() ? fmt::format("cannot be read as a picture ({})", stbi_failure_reason())
                                     : fmt::format("is {}, which is not read", other));
  }
  const long long rows = std::abs(static_cast<long long>(height));  // of a BMP, top row first
  if (width < 1 || rows < 1) throw broken(name, "has no pixels");
  check_limits(name, width, rows, std::max(stored_channels, channels));
  check_long_enough(name, width, static_cast<int>(rows), bytes);
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(rows);
  if (const std::string fault = tga_fault(bytes, pixels); !fault.empty()) throw broken(name, fault);
  Stream stream{bytes};
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> samples(
      stbi_load_from_callbacks(&stream_callbacks, &stream, &width, &height, &stored_channels, channels),
      stbi_image_free);
  if (stream.cut_short) throw broken(name, "is cut short");
  if (!samples) throw broken(name, fmt::format("cannot be decoded ({})", stbi_failure_reason()));
  Image8 image(width, height, channels == 0 ? stored_channels : channels);
  std::copy_n(samples.get(), image.samples.size(), image.samples.begin());
  return turned(image, orientation(bytes));
}

}  // namespace

Error broken(const std::string& name, const std::string& what) {
  return Error::failed(what, {name}, "use an undamaged PNG, JPEG, GIF, BMP or TGA file");
}

void check_limits(const std::string& name, long long width, long long height, int channels) {
  constexpr int largest_side = 16384;
  constexpr long long most_samples = 1LL << 28;
  if (width > largest_side || height > largest_side || width * height * channels > most_samples)
    throw Error::failed(fmt::format("{}x{} pixels of {} channels are too large", width, height, channels),
                        {name}, fmt::format("use at most {} pixels per side and 2^28 samples", largest_side));
}

void check_long_enough(const std::string& name, int width, int height, std::string_view bytes) {
  // Deflate, which packs best of all, makes at most 258 bytes from 2 bits, and a byte is at most 8 pixels.
  constexpr std::size_t most_pixels_in_a_byte = 1032 * 8;
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (pixels / most_pixels_in_a_byte > bytes.size()) throw broken(name, "is cut short");
}

Image8 parse_png(std::string_view bytes, const std::string& name, int width, int height) {
  const Size size = png_size(bytes, name);
  if (size.width != width || size.height != height)
    throw Error::failed(fmt::format("is {}x{} pixels, not {}x{}", size.width, size.height, width, height),
                        {name});
  return decode_png(bytes, name, 3);
}

Image8 load8(const std::filesystem::path& path, int channels) {
  const std::string bytes = read_file(path), name = path.string();
  if (bytes.empty()) throw broken(name, "is empty");
  return bytes.starts_with("\x89PNG") ? decode_png(bytes, name, channels) : decode(bytes, name, channels);
}

}  // namespace texel::image
