// SPDX-License-Identifier: MIT
#include "snapshot.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "image/save.hpp"

namespace texel::app {

void check_ending(const std::filesystem::path& file, View view) {
  const std::string ending = file.extension().string();
  if (ending == ".pfm" && view == View::color)
    throw Error::usage("a .pfm holds a data view, not colours", "add --view, or write a .png");
  if (ending != ".png" && ending != ".pfm")
    throw Error::usage(fmt::format("cannot write a picture to '{}'", file.string()),
                       "end the name in .png or .pfm");
}

void write_picture(const Canvas& canvas, AnyLab& lab, View view, glm::ivec2 size,
                   const std::filesystem::path& file, const std::string& renderer) {
  if (file.extension() == ".pfm") {
    image::save_pfm(file, canvas.read_float());
    return;
  }
  const image::Text texts[] = {{"Lab", lab.info().folder()},
                               {"Parameters", lab.parameters().key()},
                               {"View", kViewNames[static_cast<std::size_t>(view)]},
                               {"Size", fmt::format("{}x{}", size.x, size.y)},
                               {"Renderer", renderer}};
  const image::Image8 rgba = canvas.read8();
  image::Image8 rgb(rgba.width, rgba.height, 3);  // the target's alpha is no part of the picture
  for (std::size_t pixel = 0; pixel < rgba.samples.size() / 4; ++pixel)
    for (std::size_t c = 0; c < 3; ++c) rgb.samples[pixel * 3 + c] = rgba.samples[pixel * 4 + c];
  image::save_png(file, rgb, texts);
}

void write_snapshot(Canvas& canvas, AnyLab& lab, View view, glm::ivec2 size, int samples,
                    const std::filesystem::path& file) {
  check_ending(file, view);
  canvas.draw(view, size, samples);
  write_picture(canvas, lab, view, size, file, canvas.context().renderer());
}

}  // namespace texel::app
