// SPDX-License-Identifier: MIT
#include "course/markers.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>

#include "core/plain_text.hpp"

namespace texel::course {
namespace {

/// Past the string, character or comment that begins at `at`, or past the one letter there; npos where that
/// cannot be said: a raw string, a sign that may part digits, a backslash outside, what goes on in the next
/// line.
std::size_t end_of_piece(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  if (rest.starts_with("//")) return std::min(text.find('\n', at), text.size());
  if (rest.starts_with("/*"))
    return rest.find("*/", 2) == rest.npos ? rest.npos : text.find("*/", at + 2) + 2;
  const char quote = text[at], before = at > 0 ? text[at - 1] : ' ';
  if (quote == '\\') return text.npos;
  if (quote != '"' && quote != '\'') return at + 1;
  if (quote == '"' ? before == 'R' : is_word(before)) return text.npos;
  for (std::size_t i = at + 1; i < text.size() && text[i] != '\n'; ++i) {
    if (text[i] == quote) return i + 1;
    if (text[i] == '\\') ++i;
  }
  return text.npos;
}

/// The text without its comments, and without white space that parts nothing, as in "x * 2"; if that can be
/// said.
std::optional<std::string> code_of(std::string_view text) {
  std::string code;
  bool has_space = false;
  for (std::size_t at = 0, end = 0; at < text.size(); at = end) {
    end = end_of_piece(text, at);
    if (end == text.npos) return {};
    const std::string_view piece = text.substr(at, end - at);
    const bool is_comment = piece.starts_with("//") || piece.starts_with("/*");
    if (is_comment && piece.find('\\') != piece.npos) return {};  // it may go on in the next line
    if (is_comment || std::isspace(static_cast<unsigned char>(piece.front())) != 0) {
      has_space = true;
      continue;
    }
    if (has_space && !code.empty() && is_word(code.back()) == is_word(piece.front())) code += ' ';
    has_space = false;
    code += piece;
  }
  return code;
}

}  // namespace

bool is_same_code(std::string_view a, std::string_view b) {
  if (a == b) return true;
  const std::optional<std::string> code = code_of(a);
  return code && code == code_of(b);
}

}  // namespace texel::course
