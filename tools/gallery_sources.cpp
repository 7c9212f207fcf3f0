// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <map>

#include "commands.hpp"

namespace texel::tools {
namespace {

constexpr const char* kHead =
    "# The sources' pictures\n\n"
    "The labs implement three [sources](student.md#the-sources). Each picture that these show is drawn by "
    "one "
    "command,\n"
    "typed in the project's root; the faulty ones too. `texel gallery --list` prints this page from the "
    "labs' "
    "`lab.toml`,\n"
    "and a test holds it to that.\n";

/// A '|' would end a table's cell, also inside of code.
std::string cell(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
  return result;
}

}  // namespace

Exit list_sources() {
  std::map<std::string, std::string> rows;  // document -> its pictures, in the labs' order
  for (const course::Lab& lab : course_labs())
    for (const course::Look& look : lab.looks) {
      if (look.source.empty()) continue;
      const std::size_t comma = look.source.find(", ");
      const std::string document = look.source.substr(0, comma);
      const std::string place = comma == std::string::npos ? "" : look.source.substr(comma + 2);
      rows[document] += fmt::format("| {} | {} | `{}` |\n", cell(place), cell(look.caption),
                                    cell(course::command(lab, look)));
    }
  fmt::print("{}", kHead);
  for (const auto& [document, table] : rows)
    fmt::print("\n## {}\n\n| where | what it shows | command |\n|---|---|---|\n{}", document, table);
  return Exit::holds;
}

}  // namespace texel::tools
