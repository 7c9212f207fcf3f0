// SPDX-License-Identifier: MIT
// Commands that are scripts: what measures, and what surrounds grading in a course.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "commands.hpp"
#include "course_commands.hpp"

namespace texel::commands {

Exit run_script(const std::filesystem::path& name, const std::vector<std::string>& arguments) {
  const std::string script = (tools::course_root() / "teach/commands" / name).string();
  std::vector<char*> pointers = {const_cast<char*>(script.c_str())};
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  std::error_code error;
  ::setenv("TEXEL", std::filesystem::read_symlink("/proc/self/exe", error).c_str(), 1);
  ::execv(script.c_str(), pointers.data());
  throw Error::failed(fmt::format("cannot be started: {}", std::strerror(errno)), {script});
}

Exit run_course_script(const std::vector<std::string>& words) {
  static const std::vector<std::string> known = {"classroom", "gradebook", "gradescope", "similar"};
  const std::string name = words.empty() ? "" : words.front();
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw Error::usage(fmt::format("there is no command 'course {}'", name),
                       fmt::format("the commands are {}", fmt::join(known, ", ")));
  return run_script(std::filesystem::path("scripts") / name, {words.begin() + 1, words.end()});
}

}  // namespace texel::commands
