// SPDX-License-Identifier: MIT
#pragma once
#include <sys/mman.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace texel {

/// Reserves room in an empty vector, and asks the system to back it with pages of megabytes:
/// pages of 4 KiB, handed out one by one, took a fifth of the time of reading a large mesh. For little memory
/// this is `reserve`.
template <class Value>
void reserve_large(std::vector<Value>& values, std::size_t count) {
  values.reserve(count);
#ifdef MADV_HUGEPAGE
  constexpr std::size_t page = std::size_t{1} << 21;
  std::size_t bytes = sizeof(Value) * values.capacity();
  void* begin = values.data();
  if (bytes >= 4 * page && std::align(page, 2 * page, begin, bytes)) ::madvise(begin, bytes, MADV_HUGEPAGE);
#endif
}

}  // namespace texel
