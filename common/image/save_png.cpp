// SPDX-License-Identifier: MIT
#include "image/save.hpp"

#include <fmt/format.h>
#include <spng.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/stages.hpp"
#include "writable.hpp"

namespace texel::image {
namespace {

using Context = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;

void check(int result, const std::filesystem::path& path, const char* doing, const char* remedy) {
  if (result != SPNG_OK)
    throw Error::failed(fmt::format("cannot {} ({})", doing, spng_strerror(result)), {path.string()}, remedy);
}

void check_written(int result, const std::filesystem::path& path) {
  check(result, path, "make the PNG", "check the picture's size and texts");
}

bool is_ascii(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
}

void check_text(const std::filesystem::path& path, const Text& text) {
  const std::string& key = text.key;
  const bool printable = std::all_of(key.begin(), key.end(), [](char c) { return c >= ' ' && c <= '~'; });
  if (key.empty() || key.size() > 79 || !printable || key.front() == ' ' || key.back() == ' ' ||
      key.find("  ") != std::string::npos || text.value.find('\0') != std::string::npos)
    throw Error::failed(
        fmt::format("cannot hold the text '{}'", key), {path.string()},
        "a key has 1 to 79 printable ASCII characters, no spaces at its ends and no two spaces "
        "together, a value has no zero byte");
}

}  // namespace

std::string encode_png(const Image8& image, const std::string& name, std::span<const Text> texts,
                       int compression) {
  const std::filesystem::path path = name;
  check_not_empty(path, image);
  constexpr std::uint8_t color_types[] = {SPNG_COLOR_TYPE_GRAYSCALE, SPNG_COLOR_TYPE_GRAYSCALE_ALPHA,
                                          SPNG_COLOR_TYPE_TRUECOLOR, SPNG_COLOR_TYPE_TRUECOLOR_ALPHA};
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(image.width);
  header.height = static_cast<std::uint32_t>(image.height);
  header.bit_depth = 8;
  header.color_type = color_types[image.channels - 1];

  std::vector<spng_text> chunks;
  for (const Text& text : texts) {
    check_text(path, text);
    if (text.value.empty()) continue;  // libspng takes none
    spng_text chunk{};
    std::memcpy(chunk.keyword, text.key.c_str(), text.key.size());
    // Plain chunks hold Latin-1, international ones UTF-8.
    chunk.type = is_ascii(text.value) ? SPNG_TEXT : SPNG_ITXT;
    chunk.length = text.value.size();
    chunk.text = const_cast<char*>(text.value.c_str());  // only read: the struct serves both directions
    chunk.language_tag = const_cast<char*>("");
    chunk.translated_keyword = const_cast<char*>("");
    chunks.push_back(chunk);
  }

  const Context context(spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free);
  check_written(spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1), path);
  check_written(spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, compression), path);
  // Trying every filter on every row, libspng's default, costs three times the fastest compression itself.
  const int filters = compression <= 1 ? SPNG_FILTER_CHOICE_UP : SPNG_FILTER_CHOICE_ALL;
  check_written(spng_set_option(context.get(), SPNG_FILTER_CHOICE, filters), path);
  check_written(spng_set_ihdr(context.get(), &header), path);
  if (!chunks.empty())
    check_written(spng_set_text(context.get(), chunks.data(), static_cast<std::uint32_t>(chunks.size())),
                  path);
  check_written(spng_encode_image(context.get(), nullptr, 0, SPNG_FMT_PNG,
                                  SPNG_ENCODE_PROGRESSIVE | SPNG_ENCODE_FINALIZE),
                path);
  const std::size_t row = image.index(0, 1);
  for (int y = image.height - 1; y > 0; --y)  // PNG's first row is the top one
    check_written(spng_encode_row(context.get(), &image.at(0, y), row), path);
  const int last = spng_encode_row(context.get(), &image.at(0, 0), row);
  check_written(last == SPNG_EOI ? SPNG_OK : last, path);

  int error = SPNG_OK;
  std::size_t size = 0;
  const std::unique_ptr<void, decltype(&std::free)> bytes(spng_get_png_buffer(context.get(), &size, &error),
                                                          std::free);
  check_written(error, path);
  return {static_cast<const char*>(bytes.get()), size};
}

void save_png(const std::filesystem::path& path, const Image8& image, std::span<const Text> texts,
              int compression) {
  const Stage stage("png");
  write_file(path, encode_png(image, path.string(), texts, compression));
}

std::vector<Text> read_png_text(const std::filesystem::path& path) {
  const std::string bytes = read_file(path);
  const auto check_read = [&](int result) {
    check(result, path, "read the PNG", "use an undamaged PNG file");
  };
  const Context context(spng_ctx_new(0), spng_ctx_free);
  constexpr std::size_t largest_text = std::size_t{1} << 24;
  check_read(spng_set_chunk_limits(context.get(), largest_text, largest_text));
  check_read(spng_set_png_buffer(context.get(), bytes.data(), bytes.size()));
  std::uint32_t count = 0;
  const int found = spng_get_text(context.get(), nullptr, &count);
  if (found == SPNG_ECHUNKAVAIL) return {};
  check_read(found);
  std::vector<spng_text> chunks(count);
  check_read(spng_get_text(context.get(), chunks.data(), &count));
  std::vector<Text> texts;
  for (const spng_text& chunk : chunks) texts.push_back({chunk.keyword, {chunk.text, chunk.length}});
  return texts;
}

}  // namespace texel::image
