// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "app/assets.hpp"
#include "commands.hpp"
#include "course/markers.hpp"

namespace texel::tools {

Exit starter(const StarterOptions& options) {
  std::vector<std::string> known;
  for (const course::Lab& lab : course_labs())
    for (const course::Step& step : lab.steps) known.push_back(step.id);
  const auto is_solved = [&](const std::string& step) {
    return std::find(options.solve.begin(), options.solve.end(), step) != options.solve.end();
  };
  for (const std::string& step : options.solve)
    if (std::find(known.begin(), known.end(), step) == known.end())
      throw Error::usage(fmt::format("there is no step '{}'", step),
                         "the steps are those of labs/*/lab.toml");
  const std::filesystem::path root =
      options.root.empty() ? app::Assets().shader_root().parent_path() : options.root;
  course::write_starter(root, options.out, is_solved);
  fmt::print("wrote {}; begin there with: ./run\n", options.out.string());
  return Exit::holds;
}

}  // namespace texel::tools
