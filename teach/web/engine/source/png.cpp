// SPDX-License-Identifier: MIT
// PNG by stb in place of libspng, which Debian has for its own processors only.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "core/files.hpp"
#include "decode.hpp"
#include "image/load.hpp"
#include "image/save.hpp"

#define STBI_NO_STDIO
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace texel::image {

Size png_size(std::string_view bytes, const std::string& name) {
  Size size;
  int channels = 0;
  if (stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                            &size.width, &size.height, &channels) == 0)
    throw broken(name, fmt::format("is a damaged PNG ({})", stbi_failure_reason()));
  return size;
}

Image8 decode_png(std::string_view bytes, const std::string& name, int channels) {
  int width = 0, height = 0, stored_channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                            &width, &height, &stored_channels, channels),
      stbi_image_free);
  if (pixels == nullptr) throw broken(name, fmt::format("is a damaged PNG ({})", stbi_failure_reason()));
  Image8 top_first(width, height, channels == 0 ? stored_channels : channels);
  std::copy_n(pixels.get(), top_first.samples.size(), top_first.samples.begin());
  return flipped(top_first);
}

void save_png(const std::filesystem::path& path, const Image8& image, std::span<const Text>, int) {
  stbi_write_png_compression_level = 1;
  std::string bytes;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
  };
  const Image8 top_first = flipped(image);
  stbi_write_png_to_func(append, &bytes, image.width, image.height, image.channels, top_first.samples.data(),
                         0);
  write_file(path, bytes);
}

}  // namespace texel::image
