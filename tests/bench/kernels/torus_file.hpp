// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>

namespace texel::bench {

/// A torus as an exporter writes it: v with six decimals, vn with four, vt of a texture that is repeated, and
/// faces of v/vt/vn. The same bytes every time.
struct TorusFile {
  int segments = 0;   ///< around the axis; a multiple of `tile`
  int sides = 0;      ///< around the tube; a multiple of `tile`
  bool quads = true;  ///< faces of four corners, else of three
  int tile = 50;      ///< the texture covers this many by this many squares

  [[nodiscard]] std::uint64_t triangles() const { return std::uint64_t{2} * segments * sides; }
};

/// Writes the file piece by piece, in little memory. Throws Error (exit 3) when the disk is full.
void write_torus(const std::filesystem::path& path, const TorusFile& torus);

}  // namespace texel::bench
