// SPDX-License-Identifier: MIT
#include "course/markers.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <string>

#include "core/plain_text.hpp"

namespace texel::course {
namespace {

/// Whether a space parts nothing there: "x * 2" is "x*2". Beside a point, or behind the e of 1e-5 or the p of
/// 0x1p-5, it might part a number; beside a quote, a string from its kind; between two signs it may part
/// "+ +"; and a macro's "f (x)" is not "f(x)".
bool is_idle(const std::string& before, char next, bool in_directive) {
  if (before.empty() || before.back() == '\n') return true;
  const char last = before.back();
  constexpr std::string_view kParted = ".\"'eEpP", kParts = ".\"'";
  if (in_directive || kParted.find(last) != kParted.npos || kParts.find(next) != kParts.npos) return false;
  return is_word(last) != is_word(next);
}

/// Past the string or the character that begins at `at`, or past the one letter there; npos where that cannot
/// be said: a raw string, a sign that may part digits, and what goes on in the next line.
std::size_t literal_end(std::string_view text, std::size_t at) {
  const char quote = text[at], before = at > 0 ? text[at - 1] : ' ';
  if (quote != '"' && quote != '\'') return at + 1;
  if (quote == '"' ? before == 'R' : is_word(before)) return text.npos;
  for (std::size_t i = at + 1; i < text.size() && text[i] != '\n'; ++i) {
    if (text[i] == quote) return i + 1;
    if (text[i] == '\\' && i + 1 < text.size() && std::isspace(static_cast<unsigned char>(text[++i])) != 0)
      break;
  }
  return text.npos;
}

/// The text without its comments and idle white space, if that can be said.
std::optional<std::string> code_of(std::string_view text) {
  std::string code;
  bool has_space = false, in_directive = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view rest = text.substr(i);
    if (rest.starts_with("//")) {
      std::size_t end = i, last = 0;
      do {  // behind a backslash the comment goes on in the next line
        end = std::min(text.find('\n', end + 1), text.size());
        last = text.find_last_not_of(" \t\r", end - 1);
        if (text[last] == '\\' && last + 1 < end) return {};  // compilers differ
      } while (text[last] == '\\' && end < text.size());
      i = end - 1;
    } else if (rest.starts_with("/*")) {
      const std::size_t end = text.find("*/", i + 2);
      if (end == text.npos) return {};
      i = end + 1;
      has_space = true;
    } else if (text[i] == '\\') {
      return {};
    } else if (text[i] == '\n') {
      if (in_directive) code += '\n';
      has_space = has_space || !in_directive;
      in_directive = false;
    } else if (std::isspace(static_cast<unsigned char>(text[i])) != 0) {
      has_space = true;
    } else {
      if (text[i] == '#' && !in_directive) {
        in_directive = true;
        if (!code.empty() && code.back() != '\n') code += '\n';
      }
      if (has_space && !is_idle(code, text[i], in_directive)) code += ' ';
      has_space = false;
      const std::size_t end = literal_end(text, i);
      if (end == text.npos) return {};
      code += text.substr(i, end - i);
      i = end - 1;
    }
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
