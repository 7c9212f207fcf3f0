// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "es_source.hpp"
#include "image/load.hpp"
#include "image/save.hpp"
#include "mesh/ply.hpp"
#include "opened.hpp"
#include "web_context.hpp"

namespace texel::web {
namespace {

namespace fs = std::filesystem;

/// A case's picture for the judge. Which triangle covers a pixel at an edge is the rasteriser's choice:
/// OpenGL leaves it how finely it rounds a vertex's place. The limits were measured with 8 bits. A renderer
/// with fewer draws the picture nine times, with the vertices moved by up to half a step of its rounding. A
/// pixel that is past the limit in the first picture, and within it in another one, is taken from that.
/// Inside a triangle all nine are the same up to 1e-6, so a mistake stays one; a value that is not finite
/// stays too.
///
/// `read` gives the canvas' picture, of 4 channels; `expected` is of 3, bottom row first.
template <class Read, class Picture>
Picture with_coverage_of(const Picture& expected, const course::Case& of, app::Canvas& canvas, Read read) {
  const glm::ivec2 size(of.size.width, of.size.height);
  const auto draw = [&](float x, float y) {
    gl::set_shift(x, y);
    canvas.draw(of.view, size, 1);
    return read();
  };
  Picture first = draw(0, 0);
  const int bits = gl::subpixel_bits();
  if (bits >= gl::kEnoughSubpixelBits || expected.width != size.x || expected.height != size.y) return first;
  const auto distance = [&](const Picture& picture, std::size_t pixel) {
    double sum = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const double one = static_cast<double>(picture.samples[4 * pixel + c]) -
                         static_cast<double>(expected.samples[3 * pixel + c]);
      sum += one * one;
    }
    return std::sqrt(sum);
  };
  // Of directions, which are unit vectors, the chord.
  const double limit =
      unit_of(of.view) == course::Unit::degrees ? of.limit * std::numbers::pi / 180 : of.limit;
  // A little less than half a step: vertices lie at 1/256 of a pixel, and none may come to lie between two
  // steps.
  const float half = 15.0F / 32.0F / static_cast<float>(1 << bits);
  for (int i = 0; i < 9; ++i) {
    if (i == 4) continue;  // drawn already
    const Picture other = draw(static_cast<float>(i % 3 - 1) * half, static_cast<float>(i / 3 - 1) * half);
    for (std::size_t pixel = 0; pixel < first.samples.size() / 4; ++pixel)
      if (distance(first, pixel) > limit && distance(other, pixel) <= limit)
        for (std::size_t c = 4 * pixel; c < 4 * pixel + 4; ++c) first.samples[c] = other.samples[c];
  }
  gl::set_shift(0, 0);
  return first;
}

}  // namespace

check::Drawn draw_cases(Opened& one, const std::vector<course::Case>& cases, const fs::path& expected,
                        const fs::path& out) {
  const app::KeptValues before(one.lab.parameters());
  check::Drawn drawn;
  drawn.renderer = one.canvas.context().name();
  make_folder(out);
  for (const course::Case& it : cases) try {
      one.start.set(it.settings);
      if (it.is_mesh()) {
        write_file(out / it.file, mesh::to_ply(*one.lab.mesh(one.canvas.assets())));
        continue;
      }
      const std::string reference = read_file(expected / it.file);
      if (it.view == app::View::color)
        image::save_png(out / it.file,
                        image::without_alpha(with_coverage_of(
                            image::parse_png(reference, it.file, it.size.width, it.size.height), it,
                            one.canvas, [&] { return one.canvas.read8(); })));
      else
        image::save_pfm(out / it.file, image::without_alpha(with_coverage_of(
                                           image::parse_pfm(reference, it.file), it, one.canvas,
                                           [&] { return one.canvas.read_float(); })));
    } catch (const Error& error) {
      const Place& place = error.place();
      const std::string file = fs::path(place.file).filename();
      drawn.faults[it.file] = plain_lines(error.what());
      drawn.refused[it.file] = place.line > 0 ? fmt::format("{}:{}", file, place.line) : file;
    }
  return drawn;
}

}  // namespace texel::web
