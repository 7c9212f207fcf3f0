// SPDX-License-Identifier: MIT
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <vector>

#include "core/error.hpp"

namespace texel::bench {

/// Writes a torus as an exporter does: v with six decimals, vn with four, vt of a texture that is repeated,
/// and faces of v/vt/vn, of four corners or of three. `segments` around the axis and `sides` around the tube
/// are multiples of 50: the texture covers 50 by 50 squares. The same bytes every time. Throws Error (exit 3)
/// when the disk is full.
inline void write_torus(const std::filesystem::path& path, int segments, int sides, bool quads = true) {
  constexpr int tile = 50;
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) throw Error::failed("cannot write", {path.string()}, "is the folder there?");
  // Written in large pieces: a file's pages are slower to map where they came in small ones.
  std::vector<char> buffer(1 << 20);
  std::setvbuf(file, buffer.data(), _IOFBF, buffer.size());
  const auto angle = [](int i, int count) { return 2 * std::numbers::pi * i / count; };
  for (const char* keyword : {"v", "vn"})
    for (int i = 0; i < segments; ++i)
      for (int j = 0; j < sides; ++j) {
        const double a = angle(i, segments), b = angle(j, sides);
        const double x = std::cos(a) * std::cos(b), y = std::sin(b), z = -std::sin(a) * std::cos(b);
        if (keyword[1] == 'n')
          fmt::print(file, "vn {:.4f} {:.4f} {:.4f}\n", x, y, z);
        else
          fmt::print(file, "v {:.6f} {:.6f} {:.6f}\n", std::cos(a) + 0.4 * x, 0.4 * y, 0.4 * z - std::sin(a));
      }
  for (int i = 0; i <= tile; ++i)
    for (int j = 0; j <= tile; ++j)
      fmt::print(file, "vt {:.6f} {:.6f}\n", static_cast<double>(i) / tile, static_cast<double>(j) / tile);
  for (int i = 0; i < segments; ++i)
    for (int j = 0; j < sides; ++j) {
      const auto corner = [&](int di, int dj) {
        const int place = 1 + (i + di) % segments * sides + (j + dj) % sides;
        fmt::print(file, " {}/{}/{}", place, 1 + (i % tile + di) * (tile + 1) + j % tile + dj, place);
      };
      std::fputs("f", file);
      corner(0, 0);
      corner(1, 0);
      corner(1, 1);
      if (!quads) {
        std::fputs("\nf", file);
        corner(0, 0);
        corner(1, 1);
      }
      corner(0, 1);
      std::fputs("\n", file);
    }
  const bool failed = std::ferror(file) != 0;
  if (std::fclose(file) != 0 || failed)
    throw Error::failed("cannot write", {path.string()}, "is the disk full?");
}

}  // namespace texel::bench
