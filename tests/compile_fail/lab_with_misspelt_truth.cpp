// SPDX-License-Identifier: MIT
// error: a lab has 'static app::Truth truth(const Parameters&, glm::ivec2)' if it has the view error
#include "small_lab.hpp"

using namespace texel;

struct MyLab : MeasuredLab {
  using MeasuredLab::MeasuredLab;
  static app::Measure measure(const Parameters&) { return {app::View::color, app::Unit::steps, "a truth"}; }
#ifdef WITHOUT_FAULT
  static app::Truth truth(const Parameters&, glm::ivec2) {
    return {};
  }
#else
  static app::Truth truths(const Parameters&, glm::ivec2) {
    return {};
  }
#endif
};
template class app::LabOf<MyLab>;
