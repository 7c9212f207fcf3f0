// SPDX-License-Identifier: MIT
#include "hints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "core/files.hpp"
#include "report.hpp"

namespace texel::tools {

std::string Hints::next(const course::Step& step) {
  nlohmann::json shown = nlohmann::json::object();
  // A broken file counts as none. Only the number of shown hints is lost.
  if (std::filesystem::exists(file_)) shown = nlohmann::json::parse(read_file(file_), nullptr, false);
  if (!shown.is_object()) shown = nlohmann::json::object();
  const auto known = shown.find(step.id);
  const std::size_t before =
      known != shown.end() && known->is_number_unsigned() ? known->get<std::size_t>() : 0;
  const std::size_t count = std::min(before + 1, step.hints.size());
  shown[step.id] = count;
  make_folder(file_.parent_path());
  write_file(file_, shown.dump(1) + "\n");
  std::string text = wrapped(fmt::format("Step {}: {}", step.id, step.title), 0);
  for (std::size_t i = 0; i < count; ++i)
    text += wrapped(fmt::format("hint {} of {}: {}", i + 1, step.hints.size(), step.hints[i]), 2);
  if (before == step.hints.size()) text += "  This was the last hint.\n";
  return text;
}

std::filesystem::path hints_file() {
  return course_build() / "check/hints.json";
}

}  // namespace texel::tools
