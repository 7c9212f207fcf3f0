// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>

#include "app/lab.hpp"
#include "canvas.hpp"
#include "gl/es_source.hpp"
#include "gl/web_context.hpp"

namespace texel::web {

/// A picture for the judge. Which triangle covers a pixel at an edge is the rasteriser's choice: OpenGL
/// leaves it how finely it rounds a vertex's place. The limits were measured with 8 bits. A renderer with
/// fewer draws the picture nine times, with the vertices moved by up to half a step of its rounding, and each
/// pixel is the one nearest to the expected picture. Inside a triangle all nine are the same up to 1e-6, so
/// that a mistake stays one; a value that is not finite stays too.
///
/// `read` gives the canvas' picture, of 4 channels; `expected` is of 3, bottom row first.
template <class Read, class Picture>
Picture covered_as(const Picture& expected, app::Canvas& canvas, app::View view, glm::ivec2 size, Read read) {
  const auto draw = [&](float x, float y) {
    gl::set_shift(x, y);
    canvas.draw(view, size, 1);
    return read();
  };
  Picture best = draw(0, 0);
  const int bits = gl::subpixel_bits();
  if (bits >= gl::kEnoughSubpixelBits || expected.width != size.x || expected.height != size.y) return best;
  const auto distance = [&](const Picture& picture, std::size_t pixel) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c)
      sum += std::abs(static_cast<double>(picture.samples[4 * pixel + c]) -
                      static_cast<double>(expected.samples[3 * pixel + c]));
    return sum;
  };
  const float half = 0.5F / static_cast<float>(1 << bits);
  for (int i = 0; i < 9; ++i) {
    if (i == 4) continue;  // drawn already
    const Picture other = draw(static_cast<float>(i % 3 - 1) * half, static_cast<float>(i / 3 - 1) * half);
    for (std::size_t pixel = 0; pixel < best.samples.size() / 4; ++pixel) {
      if (!(distance(other, pixel) < distance(best, pixel))) continue;
      for (std::size_t c = 4 * pixel; c < 4 * pixel + 4; ++c) best.samples[c] = other.samples[c];
    }
  }
  gl::set_shift(0, 0);
  return best;
}

}  // namespace texel::web
