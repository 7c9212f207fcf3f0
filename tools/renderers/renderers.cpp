// SPDX-License-Identifier: MIT
#include "grade/renderers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "commands.hpp"

namespace texel::tools {

Exit renderers(const RenderersCommand& command) {
  namespace fs = std::filesystem;
  const fs::path root = course_root();
  const grade::CourseTree tree{root, course_build(),
                               command.cache.empty() ? root / "build/grade" : command.cache, chosen_labs({})};
  const auto say = [](const std::string& line) { fmt::print("{}\n", line), std::fflush(stdout); };
  std::vector<std::string> faults;
  make_folder(command.out);
  for (const grade::Renderer& renderer : grade::known_renderers(course_build() / "tools/librsqrt.so")) {
    if (!command.only.empty() &&
        std::find(command.only.begin(), command.only.end(), renderer.name) == command.only.end())
      continue;
    if (command.mutants) {
      const std::vector<std::string> passed = grade::passed_by(renderer, tree, say);
      faults.insert(faults.end(), passed.begin(), passed.end());
    } else if (!command.judge_only) {
      say(fmt::format("{}: {}", renderer.name,
                      grade::draw_by(renderer, tree, fs::absolute(command.out)) ? "drawn" : "not here"));
    }
  }
  for (const std::string& fault : faults) say(fault);
  if (command.mutants) return faults.empty() ? Exit::holds : Exit::differs;
  for (const grade::Spread& spread :
       grade::spreads(tree, fs::absolute(command.out), "mesa22_llvmpipe_osmesa")) {
    std::string text = fmt::format("{} {} limit {} most {:.3g} ratio {:.3g}", spread.lab, spread.name,
                                   spread.limit, spread.most(), spread.limit / spread.most());
    if (spread.most() * 3 > spread.limit)
      for (const auto& [name, error] : spread.by)
        if (error > 0) text += fmt::format("\n      {} {:.3g}", name, error);
    say(text);
  }
  return Exit::holds;
}

}  // namespace texel::tools
