// SPDX-License-Identifier: MIT
// What the labs here have in common. Each of them has one function with a wrong name.
#pragma once
#include "app/lab.hpp"

namespace texel {

struct SmallParameters {
  void declare(params::Set&) {}
};

struct SmallLab : app::Lab<SmallParameters> {
  static constexpr app::View kViews[] = {app::View::color};
  static constexpr app::Info info{10, "small", "Small", "As small as a lab can be.", kViews};
  explicit SmallLab(const app::Assets&) {}
  void draw(const Parameters&, app::Frame&) override {}
};

struct MeasuredLab : SmallLab {
  static constexpr app::View kViews[] = {app::View::color, app::View::error};
  static constexpr app::Info info{10, "small", "Small", "One that knows the truth.", kViews};
  using SmallLab::SmallLab;
};

}  // namespace texel
