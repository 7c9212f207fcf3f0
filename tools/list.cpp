// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "app/assets.hpp"
#include "commands.hpp"

namespace texel::tools {

std::vector<course::Lab> course_labs() {
  return course::read_labs(app::Assets().shader_root().parent_path() / "labs");
}

Exit list() {
  const std::vector<course::Lab> labs = course_labs();
  std::size_t width = 0;
  for (const course::Lab& lab : labs) width = std::max(width, lab.title.size());
  for (const course::Lab& lab : labs)
    fmt::print("{:2}  {:<{}}  {}\n", lab.number, lab.title, width, lab.lesson);
  fmt::print("\n'./run lab N' opens one; '{} --help' and the like say what each takes.\n",
             labs.front().program());
  return Exit::holds;
}

}  // namespace texel::tools
