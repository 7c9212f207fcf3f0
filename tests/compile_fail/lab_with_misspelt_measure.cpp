// SPDX-License-Identifier: MIT
// error: a lab has 'static app::Measure measure(const Parameters&)' if it has the view error
#include "small_lab.hpp"

using namespace texel;

struct MyLab : MeasuredLab {
  using MeasuredLab::MeasuredLab;
  static app::Truth truth(const Parameters&, glm::ivec2) { return {}; }
#ifdef WITHOUT_FAULT
  static app::Measure measure(const Parameters&) {
    return {app::View::color, app::Unit::steps, "a truth"};
  }
#else
  static app::Measure measures(const Parameters&) {
    return {app::View::color, app::Unit::steps, "a truth"};
  }
#endif
};
template class app::LabOf<MyLab>;
