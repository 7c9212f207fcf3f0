// SPDX-License-Identifier: MIT
// stb_image's implementation. Its memory is bounded: a picture within our limits never needs more in one
// piece than 2^28 samples of 4 bytes, but a hostile PNG may unpack to a thousand times its size. It begins as
// zeros, since a JPEG may use tables that it never defined.
#include <cstddef>
#include <cstdlib>

namespace {

constexpr std::size_t largest_block = std::size_t{1} << 30;

void* bounded_malloc(std::size_t size) {
  return size <= largest_block ? std::calloc(size, 1) : nullptr;
}

void* bounded_realloc(void* block, std::size_t size) {
  return size <= largest_block ? std::realloc(block, size) : nullptr;
}

}  // namespace

#define STBI_MALLOC(size) bounded_malloc(size)
#define STBI_REALLOC(block, size) bounded_realloc(block, size)
#define STBI_FREE(block) std::free(block)
#define STB_IMAGE_IMPLEMENTATION
#include "decoder.hpp"
