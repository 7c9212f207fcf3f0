// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>

#include "core/parallel.hpp"

namespace texel::mesh {

/// One part's share of `count` things: [begin, end), shares of neighbouring parts adjoin.
struct Share {
  std::size_t begin, end;

  Share(std::size_t count, std::size_t part, std::size_t parts)
      : begin(count * part / parts), end(count * (part + 1) / parts) {}
  [[nodiscard]] bool holds(std::size_t i) const { return i >= begin && i < end; }
};

/// As many parts as the processor has cores, but none that has less than `least` of `count` things to do:
/// less takes no longer than starting a thread.
inline unsigned parts_for(std::size_t count, std::size_t least) {
  return static_cast<unsigned>(std::clamp<std::size_t>(count / least, 1, processors()));
}

}  // namespace texel::mesh
