// SPDX-License-Identifier: MIT
#pragma once
#include <dlfcn.h>

namespace texel::test {

/// Whether this machine has OSMesa, which Mesa lacks since 25.1: else EGL draws all.
inline bool has_osmesa() {
  static const bool found = ::dlopen("libOSMesa.so.8", RTLD_LAZY | RTLD_LOCAL) != nullptr;
  return found;
}

}  // namespace texel::test
