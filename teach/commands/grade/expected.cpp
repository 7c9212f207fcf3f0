// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "commands.hpp"
#include "course_commands.hpp"
#include "grade/course_tree.hpp"

namespace texel::commands {

Exit expected(const ExpectedCommand& command) {
  const std::filesystem::path root = tools::course_root();
  const auto say = [](const std::string& line) { fmt::print("{}\n", line); };
  grade::write_expected(
      {root, tools::course_build(), command.cache.empty() ? root / "build/grade" : command.cache,
       tools::chosen_labs(command.labs)},
      say);
  return Exit::holds;
}

}  // namespace texel::commands
