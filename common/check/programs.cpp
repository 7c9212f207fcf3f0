// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "check/check.hpp"
#include "check/studio.hpp"
#include "core/plain_text.hpp"
#include "core/process.hpp"

namespace texel::grade {
namespace {

Studio studio_of(const OwnTree& tree, const course::Lab& lab, const std::string& context) {
  Studio studio;
  studio.program = tree.build / "bin" / lab.program();
  studio.root = tree.source, studio.context = context;
  studio.shader_cache = tree.build / "check/shaders";
  studio.timeouts = 1;  // somebody waits
  return studio;
}

}  // namespace

Draws by_programs(const OwnTree& tree, const std::string& context) {
  return
      [=](const course::Lab& lab, const std::vector<course::Case>& cases, const std::filesystem::path& out) {
        const Studio studio = studio_of(tree, lab, context);
        if (!std::filesystem::exists(studio.program))
          throw Error::failed("is not built", {studio.program.string()},
                              fmt::format("build it with ./run check {}", lab.number));
        return draw(studio, cases, out);
      };
}

std::string build_program(const OwnTree& tree, const course::Lab& lab) {
  const Ran ran = run_program({"cmake", "--build", tree.build.string(), "--target", lab.program()}, true);
  if (ran.exit_code == 0) return {};
  std::string messages;
  bool has_begun = ran.output.find("error:") == std::string::npos;
  for (const std::string& line : lines_of(ran.output)) {
    has_begun |= line.find("error:") != std::string::npos;
    if (has_begun && !line.starts_with("ninja:") && !line.starts_with("[") && messages.size() < 2000)
      messages += line + "\n";
  }
  // The compiler's paths begin in the build folder; editors open those that begin in the tree's root.
  for (const std::string up = "../../"; messages.find(up) != std::string::npos;)
    messages.erase(messages.find(up), up.size());
  return messages;
}

}  // namespace texel::grade
