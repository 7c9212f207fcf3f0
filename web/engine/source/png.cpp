// SPDX-License-Identifier: MIT
// PNG by stb in place of libspng, which Debian has for its own processors only.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "core/error.hpp"
#include "core/files.hpp"
#include "decoder.hpp"
#include "image/load.hpp"
#include "image/save.hpp"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace texel::image {

Image8 parse_png(std::string_view bytes, const std::string& name, int width, int height) {
  int real_width = 0, real_height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()),
                            &real_width, &real_height, &channels, 3),
      stbi_image_free);
  if (pixels == nullptr)
    throw Error::failed(fmt::format("is a damaged PNG ({})", stbi_failure_reason()), {name});
  if (real_width != width || real_height != height)
    throw Error::failed(fmt::format("is {}x{} pixels, not {}x{}", real_width, real_height, width, height),
                        {name});
  Image8 top_first(width, height, 3);
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
  if (stbi_write_png_to_func(append, &bytes, image.width, image.height, image.channels,
                             top_first.samples.data(), 0) == 0)
    throw Error::failed("cannot make the PNG", {path.string()});
  write_file(path, bytes);
}

}  // namespace texel::image
