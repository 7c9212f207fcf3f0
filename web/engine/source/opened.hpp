// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/canvas.hpp"
#include "app/lab.hpp"
#include "app/settings.hpp"

namespace texel::web {

/// A lab that was opened, with what its canvas shows.
struct Opened {
  Opened(app::AnyLab& lab_, gl::Context& context, const app::Assets& assets)
      : lab(lab_), start(lab_.parameters()), canvas(context, assets, lab_) {}
  app::AnyLab& lab;
  app::StartValues start;  ///< the defaults
  app::Canvas canvas;
  app::View view = app::View::color;
  std::optional<app::Canvas::Split> split;
};

/// While it lives, a lab may draw with other values; then the present ones are back.
class Aside {
 public:
  explicit Aside(Opened& of) : before_(of.lab.parameters()) {}
  ~Aside() { before_.set({}); }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;

 private:
  app::StartValues before_;
};

}  // namespace texel::web
