// SPDX-License-Identifier: MIT
#include "core/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "core/error.hpp"

namespace texel {

unsigned processors() {
  if (const char* variable = std::getenv("TEXEL_THREADS"); variable != nullptr && *variable != '\0') {
    constexpr unsigned most = 1024;
    unsigned threads = 0;
    const char* const end = variable + std::strlen(variable);
    const auto [read, fault] = std::from_chars(variable, end, threads);
    if (fault != std::errc() || read != end || threads == 0 || threads > most)
      throw Error::usage(fmt::format("TEXEL_THREADS is '{}', not a number of threads", variable),
                         fmt::format("set it to a number from 1 to {}, or unset it", most));
    return threads;
  }
  return std::max(1U, std::thread::hardware_concurrency());
}

void in_parallel(unsigned threads, std::size_t count, const std::function<void(std::size_t)>& act) {
  std::atomic<std::size_t> next = 0;
  // Numbers are begun in their order: when one throws, all lower ones are under way, and the lowest that
  // throws is always the same.
  std::size_t first_fault = count;
  std::exception_ptr fault;
  std::mutex mutex;
  const auto work = [&] {
    for (std::size_t i = next++; i < count; i = next++) try {
        act(i);
      } catch (...) {
        const std::scoped_lock lock(mutex);
        if (i < first_fault) {
          first_fault = i;
          fault = std::current_exception();
        }
        next = count;
      }
  };
  std::vector<std::jthread> others;
  try {
    for (unsigned i = 1; i < threads && i < count; ++i) others.emplace_back(work);
  } catch (const std::system_error&) {
    // No further thread can be had: those that there are do it all.
  }
  work();
  others.clear();
  if (fault) std::rethrow_exception(fault);
}

}  // namespace texel
