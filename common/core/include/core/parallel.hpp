// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>

namespace texel {

/// How many threads are worth having: as many as there are processors for this process, or TEXEL_THREADS
/// where others want them too. Throws Error (exit 2) when that is no number from 1 to 1024.
unsigned processors();

/// Calls `act` with 0 to count - 1 on so many threads. When one throws, no further ones are begun; of several
/// errors that of the lowest number is thrown when all have ended, whichever came first.
void in_parallel(unsigned threads, std::size_t count, const std::function<void(std::size_t)>& act);

}  // namespace texel
