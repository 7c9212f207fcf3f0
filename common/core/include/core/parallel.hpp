// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>

namespace texel {

/// How many threads are worth having.
unsigned processors();

/// Calls `act` with 0 to count - 1 on so many threads; the first error is thrown when all have ended.
void in_parallel(unsigned threads, std::size_t count, const std::function<void(std::size_t)>& act);

}  // namespace texel
