// SPDX-License-Identifier: MIT
// Portable float maps.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>

#include "core/files.hpp"
#include "decode.hpp"
#include "image/load.hpp"
#include "image/save.hpp"

namespace texel::image {

void save_pfm(const std::filesystem::path& path, const ImageF& image) {
  const int channels = image.channels == 1 ? 1 : 3;
  const std::string header =
      fmt::format("{}\n{} {}\n-1.0\n", channels == 1 ? "Pf" : "PF", image.width, image.height);
  const std::size_t samples =
      image.samples.size() / static_cast<std::size_t>(image.channels) * static_cast<std::size_t>(channels);
  std::string bytes(header.size() + samples * sizeof(float), '\0');
  char* out = std::copy(header.begin(), header.end(), bytes.data());
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      for (int c = 0; c < channels; ++c) {
        const auto bits = std::bit_cast<std::uint32_t>(c < image.channels ? image.at(x, y, c) : 0.0F);
        for (int shift = 0; shift < 32; shift += 8) *out++ = static_cast<char>(bits >> shift & 0xffU);
      }
  write_file(path, bytes);
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
