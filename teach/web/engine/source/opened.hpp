// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "app/canvas.hpp"
#include "app/settings.hpp"
#include "check/check.hpp"

namespace texel::web {

/// A lab that was opened, with what its canvas shows.
struct Opened {
  Opened(app::AnyLab& lab_, gl::Context& context, const app::Assets& assets)
      : lab(lab_), start(lab_.parameters()), canvas(context, assets, lab_) {}
  app::AnyLab& lab;
  app::KeptValues start;  ///< the defaults
  app::Canvas canvas;
  app::View view = app::View::color;
  std::optional<app::Canvas::Split> split;
};

/// Draws cases of a lab into the folder `out`, as its program does on a desktop. `expected` has what they are
/// compared with.
check::Drawn draw_cases(Opened& one, const std::vector<course::Case>& cases,
                        const std::filesystem::path& expected, const std::filesystem::path& out);

}  // namespace texel::web
