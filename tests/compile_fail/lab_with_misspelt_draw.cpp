// SPDX-License-Identifier: MIT
// error: override
#include "small_lab.hpp"

using namespace texel;

struct MyLab : SmallLab {
  using SmallLab::SmallLab;
#ifdef WITHOUT_FAULT
  void draw(const Parameters&, app::Frame&) override {}
#else
  void drawn(const Parameters&, app::Frame&) override {}
#endif
};
template class app::LabOf<MyLab>;
