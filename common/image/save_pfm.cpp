// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "core/files.hpp"
#include "image/save.hpp"
#include "writable.hpp"

namespace texel::image {

void save_pfm(const std::filesystem::path& path, const ImageF& image) {
  check_not_empty(path, image);
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

}  // namespace texel::image
