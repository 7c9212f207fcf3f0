// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>

namespace texel {

/// How many threads are worth having.
unsigned processors();

/// Calls `act` with 0 to count - 1 on so many threads. When one throws, no further ones are begun; of several
/// errors that of the lowest number is thrown when all have ended, whichever came first.
void in_parallel(unsigned threads, std::size_t count, const std::function<void(std::size_t)>& act);

}  // namespace texel
