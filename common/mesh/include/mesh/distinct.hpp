// SPDX-License-Identifier: MIT
#pragma once
#include <bit>
#include <cstdint>
#include <vector>

namespace texel::mesh {

/// Mixes 64 bits so that every input bit moves every output bit (the finaliser of SplitMix64: Steele, Lea and
/// Flood 2014, with Stafford's constants). The same on every machine.
constexpr std::uint64_t mix(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15U;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9U;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBU;
  return x ^ (x >> 31);
}

/// The bits of a float for hashing and comparing by value: -0 counts as +0.
inline std::uint32_t value_bits(float x) {
  return std::bit_cast<std::uint32_t>(x + 0.0F);
}

/// Numbers distinct things 0, 1, 2, … in order of first appearance. The caller keeps the things, gives
/// their hashes and compares them. The table (open addressing, linear probing, at most half full) needs 8
/// bytes a slot. Expected constant time for each call.
class DistinctTable {
 public:
  explicit DistinctTable(std::size_t expected = 0) { resize(std::bit_ceil(2 * expected + 16)); }

  /// The number of the thing with this hash for which `same(number)` is true; a new thing gets the next.
  template <class Same>
  std::uint32_t number(std::uint64_t hash, Same same) {
    if (2 * (std::size_t{size_} + 1) > slots_.size()) grow();
    const auto tag = static_cast<std::uint32_t>(hash >> 32);
    for (std::size_t i = tag & mask_;; i = (i + 1) & mask_) {
      Slot& slot = slots_[i];
      if (slot.number == empty) {
        slot = {tag, size_};
        return size_++;
      }
      if (slot.tag == tag && same(slot.number)) return slot.number;
    }
  }

 private:
  static constexpr std::uint32_t empty = 0xFFFFFFFFU;
  struct Slot {
    std::uint32_t tag = 0;
    std::uint32_t number = empty;
  };

  void resize(std::size_t slots) {
    slots_.assign(slots, {});
    mask_ = slots - 1;
  }
  void grow() {
    std::vector<Slot> old;
    old.swap(slots_);
    resize(2 * old.size());
    for (const Slot& slot : old) {
      if (slot.number == empty) continue;
      std::size_t i = slot.tag & mask_;
      while (slots_[i].number != empty) i = (i + 1) & mask_;
      slots_[i] = slot;
    }
  }

  std::vector<Slot> slots_;
  std::size_t mask_ = 0;
  std::uint32_t size_ = 0;
};

/// A DistinctTable with its things, which == compares.
template <class Thing>
class Distinct {
 public:
  explicit Distinct(std::size_t expected = 0) : table_(expected) {}

  std::uint32_t number(std::uint64_t hash, const Thing& thing) {
    const std::uint32_t n = table_.number(hash, [&](std::uint32_t known) { return things_[known] == thing; });
    if (n == things_.size()) things_.push_back(thing);
    return n;
  }
  [[nodiscard]] const std::vector<Thing>& things() const { return things_; }

 private:
  DistinctTable table_;
  std::vector<Thing> things_;
};

}  // namespace texel::mesh
