// SPDX-License-Identifier: MIT
// PNG by libspng. Rows of a file go from the top down, ours from the bottom up.
#include <fmt/format.h>
#include <spng.h>

#include <algorithm>
#include <cstdlib>
#include <memory>

#include "core/files.hpp"
#include "core/stages.hpp"
#include "decode.hpp"
#include "image/load.hpp"
#include "image/save.hpp"

namespace texel::image {
namespace {

using Context = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;

void check_read(int result, const std::string& name) {
  if (result == SPNG_IO_EOF || result == SPNG_EIDAT_TOO_SHORT) throw broken(name, "is cut short");
  if (result != SPNG_OK) throw broken(name, fmt::format("is a damaged PNG ({})", spng_strerror(result)));
}

/// A PNG to be read, of which every checksum has to be right.
Context opened(std::string_view bytes, const std::string& name) {
  Context context(spng_ctx_new(0), spng_ctx_free);
  constexpr std::size_t most_text = std::size_t{1} << 24U;  // bytes of all chunks that are no picture
  check_read(spng_set_chunk_limits(context.get(), most_text, most_text), name);
  check_read(spng_set_crc_action(context.get(), SPNG_CRC_ERROR, SPNG_CRC_ERROR), name);
  check_read(spng_set_png_buffer(context.get(), bytes.data(), bytes.size()), name);
  return context;
}

spng_ihdr header_of(const Context& context, const std::string& name) {
  spng_ihdr header{};
  check_read(spng_get_ihdr(context.get(), &header), name);
  // By the colour's type: grey, RGB, a palette of RGB, grey and alpha, RGBA.
  constexpr int channels[] = {1, 1, 3, 3, 2, 2, 4};
  check_limits(name, header.width, header.height, channels[header.color_type]);
  return header;
}

/// The first channels of RGBA, or grey and alpha. 16 bits are rounded to the nearest of 8.
template <class Sample>
Image8 picked(const Image<Sample>& rgba, int channels) {
  Image8 result(rgba.width, rgba.height, channels);
  for (std::size_t i = 0, n = static_cast<std::size_t>(channels); i < result.samples.size(); ++i) {
    const std::size_t channel = n == 2 ? i % n * 3 : i % n;
    const unsigned sample = rgba.samples[i / n * 4 + channel];
    result.samples[i] = static_cast<std::uint8_t>(sizeof(Sample) == 1 ? sample : (sample + 128) / 257);
  }
  return result;
}

}  // namespace

Size png_size(std::string_view bytes, const std::string& name) {
  const spng_ihdr header = header_of(opened(bytes, name), name);
  return {static_cast<int>(header.width), static_cast<int>(header.height)};
}

Image8 decode_png(std::string_view bytes, const std::string& name, int channels) {
  const Context context = opened(bytes, name);
  const spng_ihdr header = header_of(context, name);
  const int width = static_cast<int>(header.width), height = static_cast<int>(header.height);
  check_long_enough(name, width, height, bytes);
  if (channels == 0) {
    spng_trns transparent{};
    const int found = spng_get_trns(context.get(), &transparent);
    if (found != SPNG_ECHUNKAVAIL) check_read(found, name);
    const bool has_alpha = found == SPNG_OK || (header.color_type & SPNG_COLOR_TYPE_GRAYSCALE_ALPHA) != 0;
    channels = ((header.color_type & SPNG_COLOR_TYPE_TRUECOLOR) != 0 ? 3 : 1) + (has_alpha ? 1 : 0);
    check_limits(name, width, height, channels);
  }
  const auto decoded = [&](auto image, int format) {
    const int flags = image.channels == 4 ? SPNG_DECODE_TRNS : 0;
    const std::size_t size = image.samples.size() * sizeof(image.samples[0]);
    check_read(spng_decode_image(context.get(), image.samples.data(), size, format, flags), name);
    check_read(spng_decode_chunks(context.get()), name);  // to the file's end
    return flipped(image);
  };
  if (header.bit_depth == 16)
    return picked(decoded(Image<std::uint16_t>(width, height, 4), SPNG_FMT_RGBA16), channels);
  if (channels == 3) return decoded(Image8(width, height, 3), SPNG_FMT_RGB8);
  const Image8 rgba = decoded(Image8(width, height, 4), SPNG_FMT_RGBA8);
  return channels == 4 ? rgba : picked(rgba, channels);
}

std::string encode_png(const Image8& image, const std::string& name, std::span<const Text> texts,
                       int compression) {
  constexpr std::uint8_t color_types[] = {SPNG_COLOR_TYPE_GRAYSCALE, SPNG_COLOR_TYPE_GRAYSCALE_ALPHA,
                                          SPNG_COLOR_TYPE_TRUECOLOR, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA};
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(image.width);
  header.height = static_cast<std::uint32_t>(image.height);
  header.bit_depth = 8;
  header.color_type = color_types[image.channels - 1];

  std::vector<spng_text> chunks;
  for (const Text& text : texts) {
    if (text.value.empty()) continue;  // libspng takes none
    spng_text chunk{};
    text.key.copy(chunk.keyword, sizeof(chunk.keyword) - 1);
    // Plain chunks hold Latin-1, international ones UTF-8.
    const bool is_ascii = std::all_of(text.value.begin(), text.value.end(), [](char c) { return c >= 0; });
    chunk.type = is_ascii ? SPNG_TEXT : SPNG_ITXT;
    chunk.length = text.value.size();
    chunk.text = const_cast<char*>(text.value.c_str());  // only read: the struct serves both directions
    chunk.language_tag = const_cast<char*>("");
    chunk.translated_keyword = const_cast<char*>("");
    chunks.push_back(chunk);
  }

  const Context context(spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free);
  const auto check = [&](int result) {
    if (result != SPNG_OK)
      throw Error::failed(fmt::format("cannot make the PNG ({})", spng_strerror(result)), {name},
                          "check the picture's size and texts");
  };
  check(spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1));
  check(spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, compression));
  // Trying every filter on every row, libspng's default, costs three times the fastest compression itself.
  const int filters = compression <= 1 ? SPNG_FILTER_CHOICE_UP : SPNG_FILTER_CHOICE_ALL;
  check(spng_set_option(context.get(), SPNG_FILTER_CHOICE, filters));
  check(spng_set_ihdr(context.get(), &header));
  if (!chunks.empty())
    check(spng_set_text(context.get(), chunks.data(), static_cast<std::uint32_t>(chunks.size())));
  const Image8 top_first = flipped(image);
  check(spng_encode_image(context.get(), top_first.samples.data(), top_first.samples.size(), SPNG_FMT_PNG,
                          SPNG_ENCODE_FINALIZE));
  int error = SPNG_OK;
  std::size_t size = 0;
  const std::unique_ptr<void, decltype(&std::free)> bytes(spng_get_png_buffer(context.get(), &size, &error),
                                                          std::free);
  check(error);
  return {static_cast<const char*>(bytes.get()), size};
}

void save_png(const std::filesystem::path& path, const Image8& image, std::span<const Text> texts,
              int compression) {
  const Stage stage("png");
  write_file(path, encode_png(image, path.string(), texts, compression));
}

std::vector<Text> read_png_text(const std::filesystem::path& path) {
  const std::string bytes = read_file(path), name = path.string();
  const Context context = opened(bytes, name);
  std::uint32_t count = 0;
  const int found = spng_get_text(context.get(), nullptr, &count);
  if (found == SPNG_ECHUNKAVAIL) return {};
  check_read(found, name);
  std::vector<spng_text> chunks(count);
  check_read(spng_get_text(context.get(), chunks.data(), &count), name);
  std::vector<Text> texts;
  for (const spng_text& chunk : chunks) texts.push_back({chunk.keyword, {chunk.text, chunk.length}});
  return texts;
}

}  // namespace texel::image
