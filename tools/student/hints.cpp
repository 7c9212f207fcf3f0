// SPDX-License-Identifier: MIT
#include "hints.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "report.hpp"

namespace texel::tools {

std::string Hints::next(const course::Step& step) {
  Json shown = Json::object();
  // A broken file counts as none. Only the number of shown hints is lost.
  if (std::filesystem::exists(file_)) shown = json_or_null(read_file(file_));
  if (!shown.is_object()) shown = Json::object();
  const auto known = shown.find(step.id);
  const std::size_t before =
      known != shown.end() && known->is_number_unsigned() ? known->get<std::size_t>() : 0;
  const std::size_t count = std::min(before + 1, step.hints.size());
  shown[step.id] = count;
  make_folder(file_.parent_path());
  write_file(file_, to_text(shown, 1) + "\n");
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
