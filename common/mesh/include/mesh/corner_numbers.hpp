// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "mesh/distinct.hpp"
#include "mesh/obj.hpp"

namespace texel::mesh {

/// No key: corners whose vt or vn stand close together in their lists, at most 8 of each, may share it.
inline std::uint64_t hash_of(const Corner& corner) {
  return mix(mix(std::uint64_t{corner.position} << 32 | corner.texcoord >> 3) ^ corner.normal >> 3);
}

/// Numbers the vertices of the stream, each a corner unlike the ones before.
class CornerNumbers {
 public:
  explicit CornerNumbers(std::size_t expected) : table_(expected) { distinct_.reserve(expected); }

  /// The vertex of a corner: that of an equal corner (the same v, vt and vn), or a new one. Lab 3 teaches it:
  /// labs/03_obj_texcoords/corner_numbers.cpp.
  std::uint32_t number(const Corner& corner);
  [[nodiscard]] const std::vector<Corner>& distinct() const { return distinct_; }

 private:
  DistinctTable table_;
  std::vector<Corner> distinct_;
};

}  // namespace texel::mesh
