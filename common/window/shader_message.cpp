// SPDX-License-Identifier: MIT
#include "shader_message.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>

namespace texel::window {
namespace {

namespace fs = std::filesystem;

/// Reads "12:" or "12" and goes on behind it; 0 where there is no number.
int take_number(std::string_view& text) {
  int number = 0;
  const char* end = std::from_chars(text.data(), text.data() + text.size(), number).ptr;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  if (text.starts_with(':')) text.remove_prefix(1);
  return number;
}

/// "shaders/05_normal_map/normal_map.frag:20:25: …" gets a place, if there is such a file.
void find_place(ErrorMessage& message, std::string_view text, const fs::path& root) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || colon == 0) return;
  const fs::path name = text.substr(0, colon);
  std::error_code unknown;
  if (!name.is_relative() || !fs::is_regular_file(root / name, unknown)) return;
  message.file = root / name;
  text.remove_prefix(colon + 1);
  message.line = take_number(text);
  if (message.line > 0) message.column = take_number(text);
}

/// A file's line without the blanks around it, or "".
std::string line_of(const fs::path& file, int number) {
  std::ifstream stream(file);
  std::string line;
  for (int i = 0; i < number; ++i)
    if (!std::getline(stream, line)) return {};
  const std::size_t first = line.find_first_not_of(" \t"), last = line.find_last_not_of(" \t\r");
  return first == std::string::npos ? "" : line.substr(first, last - first + 1);
}

}  // namespace

ErrorMessage read_message(const std::string& text, const fs::path& root) {
  ErrorMessage message;
  const std::size_t end = text.find('\n');
  message.first = text.substr(0, end);
  if (end != std::string::npos) message.rest = text.substr(end + 1);
  if (!message.rest.empty()) message.others = 1 + static_cast<int>(std::ranges::count(message.rest, '\n'));
  find_place(message, message.first, root);
  if (message.line > 0) message.source_line = line_of(message.file, message.line);
  if (message.first.ends_with(": " + message.source_line)) message.source_line.clear();  // said already
  return message;
}

}  // namespace texel::window
