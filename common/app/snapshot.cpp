// SPDX-License-Identifier: MIT
#include "app/snapshot.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace texel::app {

void check_ending(const std::filesystem::path& file, View view) {
  const std::string ending = file.extension().string();
  if (ending == ".pfm" && view == View::color)
    throw Error::usage("a .pfm is for a data view, not for colours",
                       "add --view with a data view, or write a .png");
  if (ending != ".png" && ending != ".pfm")
    throw Error::usage(fmt::format("cannot write a picture to '{}'", file.string()),
                       "end the name in .png or .pfm");
}

Snapshot take_snapshot(const Canvas& canvas, AnyLab& lab, View view, glm::ivec2 size,
                       const std::filesystem::path& file) {
  if (file.extension() == ".pfm") return {file, {}, canvas.read_float(), {}};
  return {file,
          canvas.read8(),
          {},
          {{"Lab", lab.info().folder()},
           {"Parameters", lab.parameters().key()},
           {"View", name_of(view)},
           {"Size", fmt::format("{}x{}", size.x, size.y)},
           {"Renderer", canvas.context().name()}}};
}

void Snapshot::write() const {
  if (file.extension() == ".pfm") {
    image::save_pfm(file, values);
    return;
  }
  image::save_png(file, image::without_alpha(colors), texts);  // alpha is no part of the picture
}

}  // namespace texel::app
