// SPDX-License-Identifier: MIT
// Portable float maps.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

#include "core/files.hpp"
#include "decode.hpp"
#include "image/load.hpp"
#include "image/save.hpp"

namespace texel::image {

static_assert(std::endian::native == std::endian::little, "samples are copied as they lie in memory");

void save_pfm(const std::filesystem::path& path, const ImageF& image) {
  std::string bytes =
      fmt::format("{}\n{} {}\n-1.0\n", image.channels == 1 ? "Pf" : "PF", image.width, image.height);
  bytes.append(reinterpret_cast<const char*>(image.samples.data()), image.samples.size() * sizeof(float));
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
  ImageF image(width, height, channels);
  const std::size_t size = image.samples.size() * sizeof(float);
  if (bytes.size() != size)
    throw wrong(fmt::format("has {} bytes of samples, but its header says {}", bytes.size(), size));
  std::memcpy(image.samples.data(), bytes.data(), size);
  if (scale < 0) return image;
  for (float& sample : image.samples) {  // big-endian
    auto turned = std::bit_cast<std::array<char, sizeof(float)>>(sample);
    std::reverse(turned.begin(), turned.end());
    sample = std::bit_cast<float>(turned);
  }
  return image;
}

}  // namespace texel::image
