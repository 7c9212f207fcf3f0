// SPDX-License-Identifier: MIT
#include "image/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
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
  using namespace std::string_view_literals;
  const std::size_t header = bytes.find("IHDR") + 4;  // behind a chunk of Apple's, or at once
  if (!bytes.starts_with("\x89PNG\r\n\x1a\n"sv) || header < 16 || header > 64 || bytes.size() < header + 10)
    return;
  const auto big_endian = [&](std::size_t at) {
    long long value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value * 256 + static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  const long long width = big_endian(header);
  const long long height = big_endian(header + 4);
  // By the colour's type: grey, RGB, a palette of RGB, grey and alpha, RGBA.
  static constexpr int kChannels[] = {1, 1, 3, 3, 2, 1, 4};
  const auto type = static_cast<unsigned char>(bytes[header + 9]);
  check_limits(path, std::min(width, 1LL << 31), std::min(height, 1LL << 31), kChannels[type < 7 ? type : 0]);
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

/// The picture as Exif's `orientation` shows it, which counts rows from the top.
template <class Sample>
Image<Sample> turned(const Image<Sample>& stored, int orientation) {
  const bool on_its_side = orientation >= 5;
  const bool mirrored = orientation == 2 || orientation == 3 || orientation >= 7;
  const bool upside_down = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  Image<Sample> image(on_its_side ? stored.height : stored.width, on_its_side ? stored.width : stored.height,
                      stored.channels);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const int down = image.height - 1 - y;
      const int column = on_its_side ? down : x, row = on_its_side ? x : down;
      std::copy_n(&stored.at(mirrored ? stored.width - 1 - column : column,
                             upside_down ? row : stored.height - 1 - row),
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

/// `decode` is stbi_load_from_callbacks or its 16-bit sister.
template <class Sample, class Decode>
Image<Sample> load(const std::filesystem::path& path, const std::string& bytes, const Info& header,
                   int channels, Decode decode) {
  if (channels < 0 || channels > 4)
    throw Error::usage(fmt::format("a picture cannot have {} channels", channels), "use 1 to 4, or 0");
  check_limits(path, header.width, header.height, std::max(header.channels, channels));
  if (const std::string chunk = damaged_png_chunk(bytes); !chunk.empty())
    throw broken(path, fmt::format("is damaged: the checksum of its chunk {} is wrong", chunk));
  if (const std::string fault = tga_fault(bytes, header_pixels(header)); !fault.empty())
    throw broken(path, fault);

  Stream stream{bytes};
  int width = 0;
  int height = 0;
  int stored_channels = 0;
  const std::unique_ptr<Sample, decltype(&stbi_image_free)> samples(
      decode(&stream_callbacks, &stream, &width, &height, &stored_channels, channels), stbi_image_free);
  if (stream.cut_short) throw broken(path, "is cut short");
  if (!samples) throw broken(path, fmt::format("cannot be decoded ({})", stbi_failure_reason()));

  Image<Sample> image(width, height, channels == 0 ? stored_channels : channels);
  const auto row = static_cast<std::ptrdiff_t>(image.index(0, 1));
  for (int y = 0; y < height; ++y)  // the decoder's first row is the top one
    std::copy_n(samples.get() + (height - 1 - y) * row, row, image.samples.begin() + y * row);
  if (const int turn = orientation(bytes); turn != 1) return turned(image, turn);
  return image;
}

/// The header of a portable float map: three words, each ended by one white-space character.
class PfmHeader {
 public:
  PfmHeader(const std::string& name, std::string_view bytes) : name_(name), rest_(bytes) {
    const std::string_view kind = word();
    if (kind != "PF" && kind != "Pf") throw wrong("is not a PFM file (portable float map)");
    channels = kind == "PF" ? 3 : 1;
    width = number<int>("width");
    height = number<int>("height");
    const double scale = number<double>("scale");
    if (width < 1 || height < 1) throw wrong(fmt::format("has a size of {}x{}", width, height));
    if (!std::isfinite(scale) || scale == 0) throw wrong("has a scale that is zero or not finite");
    little_endian = scale < 0;
    check_limits(name, width, height, channels);
  }

  int width = 0;
  int height = 0;
  int channels = 0;
  bool little_endian = false;
  [[nodiscard]] std::string_view samples() const { return rest_; }
  [[nodiscard]] Error wrong(const std::string& what) const {
    return Error::failed(what, {name_}, "a PFM file starts with PF or Pf, width, height and scale");
  }

 private:
  std::string_view word() {
    const std::size_t length = rest_.substr(0, 64).find_first_of(" \t\r\n");
    if (length == std::string_view::npos) throw wrong("is not a PFM file (portable float map)");
    const std::string_view result = rest_.substr(0, length);
    rest_.remove_prefix(length + 1);
    return result;
  }
  template <class Number>
  Number number(const char* name) {
    const std::string_view text = word();
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
      throw wrong(fmt::format("has no valid {}", name));
    return value;
  }

  const std::string& name_;
  std::string_view rest_;
};

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
  if (!header.is_16_bit) return load<std::uint8_t>(path, bytes, header, channels, stbi_load_from_callbacks);
  const auto exact = load<std::uint16_t>(path, bytes, header, channels, stbi_load_16_from_callbacks);
  Image8 image(exact.width, exact.height, exact.channels);
  std::transform(exact.samples.begin(), exact.samples.end(), image.samples.begin(),
                 [](unsigned sample) { return static_cast<std::uint8_t>((sample + 128) / 257); });
  return image;
}

Image16 load16(const std::filesystem::path& path, int channels) {
  const std::string bytes = read(path);
  return load<std::uint16_t>(path, bytes, read_header(path, bytes), channels, stbi_load_16_from_callbacks);
}

ImageF load_pfm(const std::filesystem::path& path) {
  return parse_pfm(MappedFile(path).bytes(), path.string());
}

ImageF parse_pfm(std::string_view bytes, const std::string& name) {
  const PfmHeader header(name, bytes);
  const std::string_view stored = header.samples();
  const std::size_t expected = static_cast<std::size_t>(header.width) *
                               static_cast<std::size_t>(header.height) *
                               static_cast<std::size_t>(header.channels) * sizeof(float);
  if (stored.size() != expected)
    throw header.wrong(
        fmt::format("has {} bytes of samples, but its header says {}", stored.size(), expected));

  ImageF image(header.width, header.height, header.channels);
  for (std::size_t i = 0; i < image.samples.size(); ++i) {
    std::uint32_t bits = 0;
    for (std::size_t byte = 0; byte < 4; ++byte) {
      const std::size_t place = header.little_endian ? 3 - byte : byte;
      bits = bits << 8 | static_cast<unsigned char>(stored[4 * i + place]);
    }
    image.samples[i] = std::bit_cast<float>(bits);
  }
  return image;
}

}  // namespace texel::image
