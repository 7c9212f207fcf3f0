// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/assets.hpp"
#include "commands.hpp"

namespace texel::tools {

std::filesystem::path course_root() {
  return app::Assets().shader_root().parent_path();
}

std::filesystem::path course_build() {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
}

std::vector<course::Lab> course_labs() {
  return course::read_labs(course_root() / "labs");
}

std::vector<course::Lab> chosen_labs(const std::vector<int>& numbers) {
  std::vector<course::Lab> labs = course_labs();
  if (numbers.empty()) return labs;
  std::vector<int> known;
  for (const course::Lab& lab : labs) known.push_back(lab.number);
  for (const int number : numbers)
    if (std::ranges::count(known, number) == 0)
      throw Error::usage(fmt::format("there is no lab {}", number),
                         fmt::format("the labs are {}", fmt::join(known, ", ")));
  std::erase_if(labs, [&](const course::Lab& lab) { return std::ranges::count(numbers, lab.number) == 0; });
  return labs;
}

std::filesystem::path program_of(const course::Lab& lab) {
  return course_build() / "bin" / lab.program();
}

Exit list() {
  const std::vector<course::Lab> labs = course_labs();
  std::size_t width = 0;
  for (const course::Lab& lab : labs) width = std::max(width, lab.title.size());
  for (const course::Lab& lab : labs)
    fmt::print("{:2}  {:<{}}  {}\n", lab.number, lab.title, width, lab.lesson);
  fmt::print("\n'./run lab N' opens a lab. '{} --help' shows its options.\n", labs.front().program());
  return Exit::holds;
}

}  // namespace texel::tools
