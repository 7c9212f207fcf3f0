// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <future>
#include <system_error>
#include <thread>
#include <vector>

namespace texel::mesh {

/// Calls work(part) for each part of 0 to parts - 1 at the same time; when no further thread can be had, the
/// caller's does the rest. An exception of any part is thrown here.
template <class Work>
void in_parallel(unsigned parts, const Work& work) {
  std::vector<std::future<void>> others;
  unsigned begun = 1;
  try {
    for (; begun < parts; ++begun)
      others.push_back(std::async(std::launch::async, [&work, begun] { work(begun); }));
  } catch (const std::system_error&) {
  }
  work(0);
  for (; begun < parts; ++begun) work(begun);
  for (std::future<void>& other : others) other.get();
}

/// One part's share of `count` things: [begin, end), shares of neighbouring parts adjoin.
struct Share {
  std::size_t begin, end;

  Share(std::size_t count, unsigned part, unsigned parts)
      : begin(count * part / parts), end(count * (part + 1) / parts) {}
  [[nodiscard]] bool holds(std::size_t i) const { return i >= begin && i < end; }
};

/// As many parts as the processor has cores, but none that has less than `least` of `count` things to do:
/// less takes no longer than starting a thread.
inline unsigned parts_for(std::size_t count, std::size_t least) {
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  return static_cast<unsigned>(std::clamp<std::size_t>(count / least, 1, cores));
}

}  // namespace texel::mesh
