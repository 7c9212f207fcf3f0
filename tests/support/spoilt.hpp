// SPDX-License-Identifier: MIT
// Files spoilt in ways that follow from a number, so that a failure repeats.
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>

namespace texel::test {

/// SplitMix64 (G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators", 2014).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::size_t below(std::size_t limit) {
    std::uint64_t z = state_ += 0x9e3779b97f4a7c15U;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9U;
    z = (z ^ z >> 27) * 0x94d049bb133111ebU;
    return static_cast<std::size_t>((z ^ z >> 31) % limit);
  }

 private:
  std::uint64_t state_;
};

/// The content with one to four small changes.
inline std::string mutated(std::string content, Random& random) {
  constexpr std::size_t header_size = 48;
  constexpr char telling[] = {0, 1, 0x7f, '\x80', '\xff', ' ', '9', '-'};
  const std::size_t changes = 1 + random.below(4);
  for (std::size_t i = 0; i < changes && !content.empty(); ++i) {
    // Headers decide most, so half of all changes strike there.
    const bool in_header = random.below(2) == 0;
    const std::size_t at = random.below(in_header ? std::min(header_size, content.size()) : content.size());
    switch (random.below(6)) {
      case 0:
        content[at] = static_cast<char>(random.below(256));
        break;
      case 1:
        content[at] = telling[random.below(sizeof(telling))];
        break;
      case 2:
        content[at] = static_cast<char>(content[at] ^ static_cast<char>(1U << random.below(8)));
        break;
      case 3:
        content.erase(at, 1 + random.below(8));
        break;
      case 4:
        content.insert(at, 1 + random.below(8), telling[random.below(sizeof(telling))]);
        break;
      default:
        if (random.below(4) == 0) content.resize(at);
    }
  }
  return content;
}

}  // namespace texel::test
