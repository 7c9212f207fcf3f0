// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <spng.h>

#include <memory>
#include <vector>

#include "core/error.hpp"
#include "image/load.hpp"

namespace texel::image {

Image8 parse_png(std::string_view bytes, const std::string& name, int width, int height) {
  const std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)> context(spng_ctx_new(0), spng_ctx_free);
  const auto check = [&](int result) {
    if (result != 0) throw Error::failed(fmt::format("is a damaged PNG ({})", spng_strerror(result)), {name});
  };
  constexpr std::size_t most_text = 1U << 16U;  // bytes of a chunk that is no picture
  check(spng_set_chunk_limits(context.get(), most_text, most_text));
  check(spng_set_png_buffer(context.get(), bytes.data(), bytes.size()));
  spng_ihdr header{};
  check(spng_get_ihdr(context.get(), &header));
  if (header.width != static_cast<std::uint32_t>(width) ||
      header.height != static_cast<std::uint32_t>(height))
    throw Error::failed(fmt::format("is {}x{} pixels, not {}x{}", header.width, header.height, width, height),
                        {name});
  std::size_t size = 0;
  check(spng_decoded_image_size(context.get(), SPNG_FMT_RGB8, &size));
  Image8 top_first(width, height, 3);
  if (size != top_first.samples.size()) throw Error::failed("is a damaged PNG", {name});
  check(spng_decode_image(context.get(), top_first.samples.data(), size, SPNG_FMT_RGB8, 0));
  return flipped(top_first);
}

}  // namespace texel::image
