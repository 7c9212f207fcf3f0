// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "check/check.hpp"
#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "core/process.hpp"

namespace texel::check {
Draws by_programs(const OwnTree& tree, const std::string& context) {
  return
      [=](const course::Lab& lab, const std::vector<course::Case>& cases, const std::filesystem::path& out) {
        Studio studio;
        studio.program = tree.build / "bin" / lab.program();
        studio.root = tree.source, studio.context = context;
        studio.shader_cache = tree.build / "check/shaders";
        studio.timeouts = 1;  // somebody waits
        if (!std::filesystem::exists(studio.program))
          throw Error::failed("is not built", {studio.program.string()},
                              fmt::format("build it with ./run check {}", lab.number));
        return draw(studio, cases, out);
      };
}

std::string build_program(const OwnTree& tree, const course::Lab& lab, const std::string& who,
                          const std::function<void(const std::string&)>& waits) {
  // Not by lock_file: the programs that build hold this lock themselves, also when the window is closed.
  const std::string file = (tree.build / "build.lock").string();
  constexpr int kTaken = 75;
  const auto build = [&](const std::string& how) {
    return run_program({"flock", how, fmt::format("--conflict-exit-code={}", kTaken), file, "sh", "-c",
                        "printf %s \"$1\" >\"$0\"; shift; CCACHE_DISABLE=true exec \"$@\"", file, who,
                        "cmake", "--build", tree.build.string(), "--target", lab.program()},
                       true);
  };
  Ran ran = build("--nonblock");
  if (ran.exit_code == kTaken) {
    waits(std::filesystem::exists(file) ? read_file(file) : "");
    ran = build("--exclusive");
  }
  if (ran.exit_code == 0) return {};
  const auto is_error = [](const std::string& line) {  // "ld: …: undefined reference" has no such word
    return line.find("error:") != line.npos || line.find("ld: ") != line.npos;
  };
  const std::vector<std::string> lines = lines_of(ran.output);
  std::string messages;
  bool has_begun = std::none_of(lines.begin(), lines.end(), is_error), is_command = false;
  for (const std::string& line : lines) {
    has_begun |= is_error(line);
    const bool is_ninjas = is_command || line.starts_with("FAILED:") || line.starts_with("[") ||
                           (line.starts_with("ninja:") && !line.starts_with("ninja: error:") &&
                            !line.starts_with("ninja: fatal:"));
    is_command = line.starts_with("FAILED:");  // the next line
    if (has_begun && !is_ninjas && messages.size() < 2000) messages += line + "\n";
  }
  if (messages.empty()) messages = ran.output;  // a program that fails and does not say why
  // The compiler's paths begin in the build folder; editors open those that begin in the tree's root.
  for (const std::string& up : {std::string("../../"), tree.source.string() + "/"})
    while (messages.find(up) != messages.npos) messages.erase(messages.find(up), up.size());
  return messages;
}

}  // namespace texel::check
