// SPDX-License-Identifier: MIT
#include "save.hpp"

#include <spng.h>

#include <cstdlib>
#include <memory>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/files.hpp"

namespace texel::assets {

void save_png16(const std::filesystem::path& path, const image::Image16& picture) {
  const auto check = [&](int result) {
    if (result != SPNG_OK) throw Error::failed(spng_strerror(result), {path.string()});
  };
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(picture.width);
  header.height = static_cast<std::uint32_t>(picture.height);
  header.bit_depth = 16;
  header.color_type = SPNG_COLOR_TYPE_GRAYSCALE;
  std::vector<std::uint16_t> top_row_first;
  for (int y = picture.height - 1; y >= 0; --y) {
    top_row_first.insert(top_row_first.end(), &picture.at(0, y), &picture.at(0, y) + picture.width);
  }

  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> context(spng_ctx_new(SPNG_CTX_ENCODER),
                                                                    spng_ctx_free);
  check(spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1));
  check(spng_set_option(context.get(), SPNG_IMG_COMPRESSION_LEVEL, best_compression));
  check(spng_set_ihdr(context.get(), &header));
  check(spng_encode_image(context.get(), top_row_first.data(), top_row_first.size() * sizeof(std::uint16_t),
                          SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE));
  std::size_t size = 0;
  int error = SPNG_OK;
  const std::unique_ptr<void, decltype(&std::free)> bytes(spng_get_png_buffer(context.get(), &size, &error),
                                                          std::free);
  check(error);
  write_file(path, {static_cast<const char*>(bytes.get()), size});
}

}  // namespace texel::assets
