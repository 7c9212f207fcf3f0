// SPDX-License-Identifier: MIT
#include "gl/compiler_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "core/plain_text.hpp"

namespace texel::gl {
namespace {

constexpr int kLeastNumber = 100000;  // of our lines: file * 100000 + line
constexpr std::string_view kBlanks = " \t\r\v\f";

/// A line without its comments.
struct CodeLine {
  int number = 0;
  std::string text;

  [[nodiscard]] std::string_view code() const {
    const std::string_view all = text;
    const std::size_t first = all.find_first_not_of(kBlanks), last = all.find_last_not_of(kBlanks);
    return first == all.npos ? "" : all.substr(first, last - first + 1);
  }
};
/// A line, and the last one with code before it.
struct Found {
  CodeLine line, before;
};

std::string without_comments(std::string_view text) {
  std::string code;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view rest = text.substr(i);
    const bool is_line = rest.starts_with("//");
    if (!is_line && !rest.starts_with("/*")) {
      code += text[i];
      continue;
    }
    const std::size_t end = std::min(is_line ? text.find('\n', i) : text.find("*/", i + 2), text.size());
    for (std::size_t k = i; k < end; ++k)
      if (text[k] == '\n') code += '\n';
    i = is_line ? end - 1 : end + 1;
  }
  return code;
}

Found find_line(std::string_view text, int number) {
  const std::string code = without_comments(text);
  Found found;
  int next = 1;
  for (std::size_t start = 0; start < code.size();) {
    const std::size_t end = std::min(code.find('\n', start), code.size());
    CodeLine line{next++, code.substr(start, end - start)};
    start = end + 1;
    constexpr std::string_view kMark = "#line ";
    if (line.text.starts_with(kMark)) {
      std::from_chars(line.text.data() + kMark.size(), line.text.data() + line.text.size(), next);
    } else if (line.number == number) {
      found.line = std::move(line);
      return found;
    } else if (!line.code().empty() && !line.code().starts_with('#')) {
      found.before = std::move(line);
    }
  }
  return {};
}

/// Whether a statement may end here, and does not by itself.
bool wants_semicolon(std::string_view code) {
  if (code.empty()) return false;
  for (const std::string_view head : {"if", "for", "while", "else", "do", "switch"})
    if (code.starts_with(head) && (code.size() == head.size() || !is_word(code[head.size()])) &&
        (code.ends_with(')') || code == head))
      return false;
  return is_word(code.back()) || code.ends_with(')') || code.ends_with(']') || code.ends_with('}') ||
         code.ends_with("++") || code.ends_with("--");
}

/// Of one line of the log.
std::string at_missing_semicolon(std::string_view line, std::string_view text) {
  // Mesa: "0:500012(3): error: syntax error, unexpected RETURN, expecting ',' or ';'". NVIDIA: "0(500012) :
  // error C0000: syntax error, unexpected '}', expecting ',' or ';' at token "}"". ANGLE: "ERROR: 0:500012:
  // '}' : syntax error".
  if (line.find("syntax error") == line.npos) return std::string(line);
  const bool says_what = line.find("expecting") != line.npos;
  if (says_what && (line.find("';'") == line.npos || line.find("'{'", line.find("expecting")) != line.npos))
    return std::string(line);
  int number = 0;
  std::size_t behind = 0;
  for (std::size_t at = 0; at < line.size() && number < kLeastNumber; at = std::max(at + 1, behind)) {
    number = 0;
    behind = static_cast<std::size_t>(
        std::from_chars(line.data() + at, line.data() + line.size(), number).ptr - line.data());
  }
  if (number < kLeastNumber) return std::string(line);
  const auto [found, before] = find_line(text, number);
  const std::string_view code = found.code();
  // What was not expected must be the line's first: Mesa gives a column, from 0 or 1, and the others the
  // token.
  bool is_first = false;
  if (line.substr(behind).starts_with('(')) {
    std::size_t column = 0;
    std::from_chars(line.data() + behind + 1, line.data() + line.size(), column);
    is_first = found.text.find_first_not_of(kBlanks) + 1 >= column;
  } else {
    const std::size_t token = line.find("at token \"");
    const std::size_t from = token != line.npos ? token + 10 : line.find('\'', behind) + 1;
    const std::size_t to = line.find(token != line.npos ? '"' : '\'', from);
    is_first = from != 0 && to != line.npos && to > from && code.starts_with(line.substr(from, to - from));
  }
  if (code.empty() || !is_first || !wants_semicolon(before.code())) return std::string(line);
  return fmt::format("0:{}: error: a ';' is missing at the end of this line: {}", before.number,
                     before.code());
}

}  // namespace

std::string at_missing_semicolons(std::string_view log, std::string_view text) {
  std::string result;
  for (std::size_t start = 0; start < log.size();) {
    const std::size_t end = std::min(log.find('\n', start), log.size());
    result += at_missing_semicolon(log.substr(start, end - start), text) + "\n";
    start = end + 1;
  }
  return result;
}

}  // namespace texel::gl
