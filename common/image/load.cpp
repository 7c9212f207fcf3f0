// SPDX-License-Identifier: MIT
#include "image/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <memory>
#include <string_view>

#include "core/error.hpp"
#include "core/files.hpp"
#include "decoder.hpp"
#include "guards.hpp"

namespace texel::image {
namespace {

constexpr int largest_side = 16384;
constexpr long long most_samples = 1LL << 28;

Error broken(const std::filesystem::path& path, const std::string& what) {
  return Error::failed(what, {path.string()}, "use an undamaged PNG, JPEG, GIF, BMP or TGA file");
}

void check_limits(const std::filesystem::path& path, long long width, long long height, int channels) {
  if (width > largest_side || height > largest_side || width * height * channels > most_samples)
    throw Error::failed(fmt::format("{}x{} pixels of {} channels are too large", width, height, channels),
                        {path.string()},
                        fmt::format("use at most {} pixels per side and 2^28 samples", largest_side));
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

/// A PNG's own size, from its first chunk; stb_image does not tell it where it thinks it too large.
void check_png_limits(const std::filesystem::path& path, std::string_view bytes) {
  const std::size_t header = bytes.find("IHDR") + 4;  // behind a chunk of Apple's, or at once
  if (!bytes.starts_with(png_signature) || header < 16 || header > 64 || bytes.size() < header + 10) return;
  const Bytes png{bytes};
  // By the colour's type: grey, RGB, a palette of RGB, grey and alpha, RGBA.
  static constexpr int kChannels[] = {1, 1, 3, 3, 2, 1, 4};
  const std::size_t type = png[header + 9], most = std::size_t{1} << 31U;
  check_limits(path, static_cast<long long>(std::min(png.big_endian32(header), most)),
               static_cast<long long>(std::min(png.big_endian32(header + 4), most)),
               kChannels[type < 7 ? type : 0]);
}

std::size_t header_pixels(const Info& header) {
  return static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
}

Info read_header(const std::filesystem::path& path, std::string_view bytes) {
  if (bytes.empty()) throw broken(path, "is empty");
  check_png_limits(path, bytes);
  if (const std::string fault = jpeg_fault(bytes); !fault.empty()) throw broken(path, fault);
  static const bool once = [] {  // Apple's variant of PNG: BGR, multiplied by alpha
    stbi_convert_iphone_png_to_rgb(1);
    stbi_set_unpremultiply_on_load(1);
    return true;
  }();
  static_cast<void>(once);
  Info header;
  Stream stream{bytes};
  if (stbi_info_from_callbacks(&stream_callbacks, &stream, &header.width, &header.height, &header.channels) ==
      0) {
    const std::string other = other_format(bytes);
    throw broken(path, other.empty() ? fmt::format("cannot be read as a picture ({})", stbi_failure_reason())
                                     : fmt::format("is {}, which is not read", other));
  }
  if (header.height >= -largest_side) header.height = std::abs(header.height);  // of a BMP, top row first
  if (header.width < 1 || header.height < 1) throw broken(path, "has no pixels");
  check_limits(path, header.width, header.height, header.channels);
  // Deflate, which packs best of all, makes at most 258 bytes from 2 bits, and a byte is at most 8 pixels: a
  // tiny file with a huge header is refused before its picture is allocated.
  constexpr std::size_t most_pixels_in_a_byte = 1032 * 8;
  if (header_pixels(header) / most_pixels_in_a_byte > bytes.size()) throw broken(path, "is cut short");
  Stream again{bytes};
  header.is_16_bit = stbi_is_16_bit_from_callbacks(&stream_callbacks, &again) != 0;
  return header;
}

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

/// The file's bytes as the decoder reads them best.
std::string read(const std::filesystem::path& path) {
  std::string bytes = read_file(path);
  make_tga_plain(bytes);
  return bytes;
}

/// `decode` is stbi_load_from_callbacks or its 16-bit sister; `rounded` makes 8 bits of its samples. The
/// first row is the top one.
template <class Decode, class Rounded>
Image8 decoded(const std::filesystem::path& path, std::string_view bytes, int channels, Decode decode,
               Rounded rounded) {
  Stream stream{bytes};
  int width = 0, height = 0, stored_channels = 0;
  const auto* const samples = decode(&stream_callbacks, &stream, &width, &height, &stored_channels, channels);
  const std::unique_ptr<const void, void (*)(const void*)> owner(
      samples, [](const void* block) { stbi_image_free(const_cast<void*>(block)); });
  if (stream.cut_short) throw broken(path, "is cut short");
  if (!samples) throw broken(path, fmt::format("cannot be decoded ({})", stbi_failure_reason()));
  Image8 image(width, height, channels == 0 ? stored_channels : channels);
  std::transform(samples, samples + image.samples.size(), image.samples.begin(), rounded);
  return image;
}

}  // namespace

Info info(const std::filesystem::path& path) {
  const std::string bytes = read(path);
  Info header = read_header(path, bytes);
  if (orientation(bytes) >= 5) std::swap(header.width, header.height);
  return header;
}

Image8 load8(const std::filesystem::path& path, int channels) {
  const std::string bytes = read(path);
  const Info header = read_header(path, bytes);
  if (channels < 0 || channels > 4)
    throw Error::usage(fmt::format("a picture cannot have {} channels", channels), "use 1 to 4, or 0");
  check_limits(path, header.width, header.height, std::max(header.channels, channels));
  if (const std::string chunk = damaged_png_chunk(bytes); !chunk.empty())
    throw broken(path, fmt::format("is damaged: the checksum of its chunk {} is wrong", chunk));
  if (const std::string fault = tga_fault(bytes, header_pixels(header)); !fault.empty())
    throw broken(path, fault);
  const auto to_8_bits = [](unsigned sample) { return static_cast<std::uint8_t>((sample + 128) / 257); };
  const Image8 stored = header.is_16_bit
                            ? decoded(path, bytes, channels, stbi_load_16_from_callbacks, to_8_bits)
                            : decoded(path, bytes, channels, stbi_load_from_callbacks, std::identity());
  return turned(stored, orientation(bytes));
}

ImageF load_pfm(const std::filesystem::path& path) {
  return parse_pfm(MappedFile(path).bytes(), path.string());
}

ImageF parse_pfm(std::string_view bytes, const std::string& name) {
  const auto wrong = [&](const std::string& what) {
    return Error::failed(what, {name}, "a PFM file starts with PF or Pf, width, height and scale");
  };
  const auto word = [&] {  // of the header: each is ended by one white-space character
    const std::size_t length = bytes.substr(0, 64).find_first_of(" \t\r\n");
    if (length == std::string_view::npos) throw wrong("is not a PFM file (portable float map)");
    const std::string_view result = bytes.substr(0, length);
    bytes.remove_prefix(length + 1);
    return result;
  };
  const auto number = [&](const char* what, auto value) {
    const std::string_view text = word();
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
      throw wrong(fmt::format("has no valid {}", what));
    return value;
  };
  const std::string_view kind = word();
  if (kind != "PF" && kind != "Pf") throw wrong("is not a PFM file (portable float map)");
  const int channels = kind == "PF" ? 3 : 1, width = number("width", 0), height = number("height", 0);
  const double scale = number("scale", 0.0);
  if (width < 1 || height < 1) throw wrong(fmt::format("has a size of {}x{}", width, height));
  if (!std::isfinite(scale) || scale == 0) throw wrong("has a scale that is zero or not finite");
  check_limits(name, width, height, channels);
  const std::size_t samples =
      static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels);
  if (bytes.size() != 4 * samples)
    throw wrong(fmt::format("has {} bytes of samples, but its header says {}", bytes.size(), 4 * samples));

  ImageF image(width, height, channels);
  for (std::size_t i = 0; i < samples; ++i) {
    std::uint32_t bits = 0;
    for (std::size_t byte = 0; byte < 4; ++byte)
      bits = bits << 8 | static_cast<unsigned char>(bytes[4 * i + (scale < 0 ? 3 - byte : byte)]);
    image.samples[i] = std::bit_cast<float>(bits);
  }
  return image;
}

}  // namespace texel::image
