// SPDX-License-Identifier: MIT
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace texel::tools {

inline void add_context(CLI::App* command, std::string& context) {
  command->add_option("--context", context, "Where OpenGL comes from")
      ->check(CLI::IsMember({"auto", "osmesa", "egl"}));
}

}  // namespace texel::tools
