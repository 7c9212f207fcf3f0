// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/assets.hpp"
#include "commands.hpp"
#include "core/process.hpp"

namespace texel::tools {

std::filesystem::path course_root() {
  return app::Assets().shader_root().parent_path();
}

std::filesystem::path course_build() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path().parent_path();
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
    if (std::find(known.begin(), known.end(), number) == known.end())
      throw Error::usage(fmt::format("there is no lab {}", number),
                         fmt::format("the labs are {}", fmt::join(known, ", ")));
  std::erase_if(labs, [&](const course::Lab& lab) {
    return std::find(numbers.begin(), numbers.end(), lab.number) == numbers.end();
  });
  return labs;
}

std::filesystem::path program_of(const course::Lab& lab) {
  return course_build() / "bin" / lab.program();
}

bool knows_truth(const course::Lab& lab) {
  const Ran ran = run_program({program_of(lab), "--list-views"});
  if (ran.exit_code != 0)
    throw Error::failed("does not list its views; build it again with ./run build",
                        {program_of(lab).string()});
  return ("\n" + ran.output).find("\nerror\n") != std::string::npos;
}

void make_folder(const std::filesystem::path& folder) {
  if (folder.empty()) return;  // of a file that lies here
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error)
    throw Error::failed(fmt::format("cannot make the folder: {}", error.message()), {folder.string()});
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
