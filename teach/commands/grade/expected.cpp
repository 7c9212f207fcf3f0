// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "commands.hpp"
#include "course_commands.hpp"
#include "grade/course_tree.hpp"

namespace texel::tools {

Exit expected(const ExpectedCommand& command) {
  const std::filesystem::path root = course_root();
  const auto say = [](const std::string& line) { fmt::print("{}\n", line); };
  grade::write_expected({root, course_build(), command.cache.empty() ? root / "build/grade" : command.cache,
                         chosen_labs(command.labs)},
                        say);
  return Exit::holds;
}

}  // namespace texel::tools
