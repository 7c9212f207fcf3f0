// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <set>

#include "commands.hpp"
#include "course_commands.hpp"
#include "material/starter.hpp"

namespace texel::commands {

namespace {

Exit verify(const StarterOptions& options) {
  const std::vector<std::string> faults =
      grade::verify_starter(course_tree(options.labs, options.cache),
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
  std::set<std::string> unknown(options.solve.begin(), options.solve.end());
  const std::set<std::string> solved = unknown;
  for (const course::Lab& lab : tools::course_labs())
    for (const course::Step& step : lab.steps) unknown.erase(step.id);
  if (!unknown.empty())
    throw Error::usage(fmt::format("there is no step '{}'", *unknown.begin()),
                       "labs/*/lab.toml lists the steps");
  const auto is_solved = [&](const std::string& step) { return solved.contains(step); };
  material::write_files(material::starter_files(tools::course_root(), is_solved), options.out);
  fmt::print("wrote {}; start there with: ./run\n", options.out.string());
  return Exit::holds;
}

}  // namespace texel::commands
