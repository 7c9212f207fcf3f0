// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>

namespace texel {

/// How many threads to use: TEXEL_THREADS if it is set (others may need the processors too), else one per
/// processor of this process. Throws Error (exit 2) when TEXEL_THREADS is not a number from 1 to 1024.
unsigned processors();

/// Calls `act` with 0 to count - 1 on this many threads. After an error no further call begins. When all
/// have ended, the error with the lowest number is thrown.
void in_parallel(unsigned threads, std::size_t count, const std::function<void(std::size_t)>& act);

}  // namespace texel
