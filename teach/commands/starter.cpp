// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "commands.hpp"
#include "course_commands.hpp"
#include "grade/course_tree.hpp"
#include "material/starter.hpp"

namespace texel::commands {

namespace {

Exit verify(const StarterOptions& options) {
  const std::filesystem::path root = tools::course_root();
  const std::vector<std::string> faults = grade::verify_starter(
      {root, tools::course_build(), options.cache.empty() ? root / "build/grade" : options.cache,
       tools::chosen_labs(options.labs)},
      [](const std::string& line) { fmt::print(stderr, "{}\n", line); });
  for (const std::string& fault : faults) fmt::print("{}\n", fault);
  if (faults.empty())
    fmt::print(
        "the starter fails every step; with the first k steps solved, exactly those pass; all pass in the "
        "end\n");
  return faults.empty() ? Exit::holds : Exit::differs;
}

}  // namespace

Exit starter(const StarterOptions& options) {
  if (options.verify) return verify(options);
  if (!options.pictures.empty()) return step_pictures(options);
  if (options.out.empty())
    throw Error::usage("the folder is missing; type texel starter --out DIR", "DIR is a new folder");
  std::vector<std::string> known;
  for (const course::Lab& lab : tools::course_labs())
    for (const course::Step& step : lab.steps) known.push_back(step.id);
  const auto is_solved = [&](const std::string& step) {
    return std::find(options.solve.begin(), options.solve.end(), step) != options.solve.end();
  };
  for (const std::string& step : options.solve)
    if (std::find(known.begin(), known.end(), step) == known.end())
      throw Error::usage(fmt::format("there is no step '{}'", step), "labs/*/lab.toml lists the steps");
  const std::filesystem::path root = options.root.empty() ? tools::course_root() : options.root;
  material::write_files(material::starter_files(root, is_solved), options.out);
  fmt::print("wrote {}; start there with: ./run\n", options.out.string());
  return Exit::holds;
}

}  // namespace texel::commands
