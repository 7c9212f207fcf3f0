// SPDX-License-Identifier: MIT
// error: a lab has 'static app::Truth truth(const Parameters&, glm::ivec2)' if it has the view error
#include "small_lab.hpp"

using namespace texel;

struct MyLab : SmallLab {
  using SmallLab::SmallLab;
#ifndef WITHOUT_FAULT
  static app::Truth truth(const Parameters&, glm::ivec2) {
    return {};
  }
#endif
};
template class app::LabOf<MyLab>;
