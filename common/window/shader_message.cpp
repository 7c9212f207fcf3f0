// SPDX-License-Identifier: MIT
#include "shader_message.hpp"

#include <algorithm>

#include "core/files.hpp"
#include "core/pattern.hpp"
#include "core/plain_text.hpp"

namespace texel::window {
namespace {

namespace fs = std::filesystem;

/// "shaders/05_normal_map/normal_map.frag:20:25: …" gets a place, if there is such a file.
void find_place(ErrorMessage& message, const fs::path& root) {
  static const Pattern kPlace("([^:]+):(?:([0-9]{1,9})(?::([0-9]{1,9}))?)?");
  const Pattern::Groups found = kPlace.match_begin(message.first);
  std::error_code unknown;
  if (found.empty()) return;
  const fs::path name = found[1];
  if (!name.is_relative() || !fs::is_regular_file(root / name, unknown)) return;
  message.file = root / name;
  if (!found[2].empty()) message.line = std::stoi(found[2]);
  if (!found[3].empty()) message.column = std::stoi(found[3]);
}

}  // namespace

ErrorMessage read_message(const std::string& text, const fs::path& root) {
  ErrorMessage message;
  const std::size_t end = text.find('\n');
  message.first = text.substr(0, end);
  if (end != std::string::npos) message.rest = text.substr(end + 1);
  if (!message.rest.empty()) message.others = 1 + static_cast<int>(std::ranges::count(message.rest, '\n'));
  find_place(message, root);
  if (message.line > 0) {
    const std::vector<std::string> lines = lines_of(read_file(message.file));
    const auto index = static_cast<std::size_t>(message.line) - 1;
    if (index < lines.size()) message.source_line = trimmed(lines[index]);
  }
  if (message.first.ends_with(": " + message.source_line)) message.source_line.clear();  // said already
  return message;
}

}  // namespace texel::window
