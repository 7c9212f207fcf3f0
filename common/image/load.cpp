// SPDX-License-Identifier: MIT
#include "image/load.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
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
  if (!bytes.starts_with("\x89PNG\r\n\x1a\n"sv) || bytes.size() < 26) return;
  const auto big_endian = [&](std::size_t at) {
    long long value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value * 256 + static_cast<unsigned char>(bytes[at + i]);
    return value;
  };
  const long long width = big_endian(16);
  const long long height = big_endian(20);
  // By the colour's type: grey, RGB, a palette of RGB, grey and alpha, RGBA.
  static constexpr int kChannels[] = {1, 1, 3, 3, 2, 1, 4};
  const auto type = static_cast<unsigned char>(bytes[25]);
  check_limits(path, std::min(width, 1LL << 31), std::min(height, 1LL << 31), kChannels[type < 7 ? type : 0]);
}

std::size_t header_pixels(const Info& header) {
  return static_cast<std::size_t>(header.width) * static_cast<std::size_t>(header.height);
}

Info read_header(const std::filesystem::path& path, std::string_view bytes) {
  if (bytes.empty()) throw broken(path, "is empty");
  check_png_limits(path, bytes);
  if (jpeg_overruns(bytes)) throw broken(path, "has invalid JPEG tables");
  Info header;
  Stream stream{bytes};
  if (stbi_info_from_callbacks(&stream_callbacks, &stream, &header.width, &header.height, &header.channels) ==
      0)
    throw broken(path, fmt::format("cannot be read as a picture ({})", stbi_failure_reason()));
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

/// `decode` is stbi_load_from_callbacks or its 16-bit sister.
template <class Sample, class Decode>
Image<Sample> load(const std::filesystem::path& path, int channels, Decode decode) {
  if (channels < 0 || channels > 4)
    throw Error::usage(fmt::format("a picture cannot have {} channels", channels), "use 1 to 4, or 0");
  const std::string bytes = read_file(path);
  const Info header = read_header(path, bytes);
  check_limits(path, header.width, header.height, std::max(header.channels, channels));
  if (const std::string chunk = damaged_png_chunk(bytes); !chunk.empty())
    throw broken(path, fmt::format("is damaged: the checksum of its chunk {} is wrong", chunk));
  if (tga_is_cut_short(bytes, header_pixels(header))) throw broken(path, "is cut short");

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
  return read_header(path, read_file(path));
}

Image8 load8(const std::filesystem::path& path, int channels) {
  return load<std::uint8_t>(path, channels, stbi_load_from_callbacks);
}

Image16 load16(const std::filesystem::path& path, int channels) {
  return load<std::uint16_t>(path, channels, stbi_load_16_from_callbacks);
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
