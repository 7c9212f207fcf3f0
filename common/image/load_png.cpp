// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <spng.h>

#include <memory>
#include <vector>

#include "core/error.hpp"
#include "core/files.hpp"
#include "image/load.hpp"

namespace texel::image {

Image8 load_png(const std::filesystem::path& path, int width, int height) {
  const MappedFile file(path);
  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> context(spng_ctx_new(0), spng_ctx_free);
  const auto check = [&](int result) {
    if (result != 0)
      throw Error::failed(fmt::format("is a damaged PNG ({})", spng_strerror(result)), {path.string()});
  };
  constexpr std::size_t most_text = 1U << 16U;  // bytes of a chunk that is no picture
  check(spng_set_chunk_limits(context.get(), most_text, most_text));
  check(spng_set_png_buffer(context.get(), file.bytes().data(), file.bytes().size()));
  spng_ihdr header{};
  check(spng_get_ihdr(context.get(), &header));
  if (header.width != static_cast<std::uint32_t>(width) ||
      header.height != static_cast<std::uint32_t>(height))
    throw Error::failed(fmt::format("is {}x{} pixels, not {}x{}", header.width, header.height, width, height),
                        {path.string()});
  std::size_t size = 0;
  check(spng_decoded_image_size(context.get(), SPNG_FMT_RGB8, &size));
  Image8 top_first(width, height, 3);
  if (size != top_first.samples.size()) throw Error::failed("is a damaged PNG", {path.string()});
  check(spng_decode_image(context.get(), top_first.samples.data(), size, SPNG_FMT_RGB8, 0));
  return flipped(top_first);
}

}  // namespace texel::image
