// SPDX-License-Identifier: MIT
// error: override
#include "small_lab.hpp"

using namespace texel;

struct MyLab : SmallLab {
  using SmallLab::SmallLab;
#ifdef WITHOUT_FAULT
  const mesh::Mesh* mesh(const Parameters&) override {
    return nullptr;
  }
#else
  const mesh::Mesh* meshes(const Parameters&) override {
    return nullptr;
  }
#endif
};
template class app::LabOf<MyLab>;
