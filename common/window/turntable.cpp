// SPDX-License-Identifier: MIT
#include "turntable.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/snapshot.hpp"
#include "core/error.hpp"

namespace texel::window {

Turntable::Turntable(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code fault;
  std::filesystem::create_directory(folder_, fault);
  if (fault)
    throw Error::failed("cannot make this folder: " + fault.message(), {folder_.string()},
                        "start the program in a folder where you may write");
}

void Turntable::write_next(app::Canvas& canvas, app::AnyLab& lab, app::View view, glm::ivec2 size,
                           int samples) {
  params::Parameter* turn = lab.parameters().find("turn");
  params::Parameter& angle = turn != nullptr ? *turn : lab.parameters().at("yaw");
  const double before = angle.value();
  angle.set_value(std::remainder(before + 360.0 * written_ / kPictures, 360));
  try {
    canvas.draw(view, size, samples);
    app::take_snapshot(canvas, lab, view, size, folder_ / fmt::format("{:03}.png", written_)).write();
  } catch (...) {
    angle.set_value(before);
    throw;
  }
  angle.set_value(before);
  ++written_;
}

}  // namespace texel::window
