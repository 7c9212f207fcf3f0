// SPDX-License-Identifier: MIT
#include "core/stopwatch.hpp"

#include <fmt/format.h>

namespace texel {

std::string duration_text(double seconds) {
  return seconds < 90 ? fmt::format("{:.0f} s", seconds) : fmt::format("{:.0f} min", seconds / 60);
}

}  // namespace texel
