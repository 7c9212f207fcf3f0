// SPDX-License-Identifier: MIT
#include "torus_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>

#include "core/error.hpp"

namespace texel::bench {

void write_torus(const std::filesystem::path& path, const TorusFile& torus) {
  std::ofstream file(path, std::ios::binary);
  fmt::memory_buffer text;
  const auto flush = [&](std::size_t least) {
    if (text.size() < least) return;
    file.write(text.data(), static_cast<std::streamsize>(text.size()));
    text.clear();
  };
  const auto write = [&](auto format, auto... values) {
    fmt::format_to(std::back_inserter(text), fmt::runtime(format), values...);
    flush(1 << 20);
  };
  const auto angle = [](int i, int count) { return 2 * std::numbers::pi * i / count; };

  for (const char* keyword : {"v", "vn"})
    for (int i = 0; i < torus.segments; ++i)
      for (int j = 0; j < torus.sides; ++j) {
        const double a = angle(i, torus.segments), b = angle(j, torus.sides);
        const double x = std::cos(a) * std::cos(b), y = std::sin(b), z = -std::sin(a) * std::cos(b);
        if (keyword[1] == 'n')
          write("vn {:.4f} {:.4f} {:.4f}\n", x, y, z);
        else
          write("v {:.6f} {:.6f} {:.6f}\n", std::cos(a) + 0.4 * x, 0.4 * y, 0.4 * z - std::sin(a));
      }
  for (int i = 0; i <= torus.tile; ++i)
    for (int j = 0; j <= torus.tile; ++j)
      write("vt {:.6f} {:.6f}\n", static_cast<double>(i) / torus.tile, static_cast<double>(j) / torus.tile);
  const auto corner = [&](int i, int j, int s, int t) {
    const int place = 1 + i % torus.segments * torus.sides + j % torus.sides;
    write(" {}/{}/{}", place, 1 + s * (torus.tile + 1) + t, place);
  };
  for (int i = 0; i < torus.segments; ++i)
    for (int j = 0; j < torus.sides; ++j) {
      const int s = i % torus.tile, t = j % torus.tile;
      write("f");
      corner(i, j, s, t);
      corner(i + 1, j, s + 1, t);
      corner(i + 1, j + 1, s + 1, t + 1);
      if (!torus.quads) {
        write("\nf");
        corner(i, j, s, t);
        corner(i + 1, j + 1, s + 1, t + 1);
      }
      corner(i, j + 1, s, t + 1);
      write("\n");
    }
  flush(1);
  file.close();
  if (!file) throw Error::failed("cannot write", {path.string()}, "is the disk full?");
}

}  // namespace texel::bench
