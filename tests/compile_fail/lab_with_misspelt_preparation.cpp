// SPDX-License-Identifier: MIT
// error: override
#include "small_lab.hpp"

using namespace texel;

struct MyLab : SmallLab {
  using SmallLab::SmallLab;
#ifdef WITHOUT_FAULT
  std::optional<app::Preparation> preparation(const Parameters&) override {
    return {};
  }
#else
  std::optional<app::Preparation> preparations(const Parameters&) override {
    return {};
  }
#endif
};
template class app::LabOf<MyLab>;
