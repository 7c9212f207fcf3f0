// SPDX-License-Identifier: MIT
#include "course/step_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/plain_text.hpp"

namespace texel::course {
namespace {

constexpr std::size_t kMostLines = 200;  // of a step whose last marker is gone
constexpr std::size_t kMostBefore = 6;   // of the function's head

/// The index behind the bracket that closes the one at `open`.
std::size_t behind_bracket(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    depth += text[i] == '{' ? 1 : text[i] == '}' ? -1 : 0;
    if (depth == 0) return i + 1;
  }
  return text.size();
}

/// Digits raised and lowered, as Unicode has them.
constexpr std::array<const char*, 10> kRaised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
constexpr std::array<const char*, 10> kLowered = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};

/// Of formulas that stand in lines of their own.
constexpr const char* kIndent = "   ";

/// LaTeX as the handouts use it, in Unicode; where it has a wide gap begins another line.
std::string formula(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const char next = i + 1 < text.size() ? text[i + 1] : '\0';
    if (c == '\\') {
      std::size_t end = i + 1;
      while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0) ++end;
      const std::string_view word = text.substr(i + 1, end - i - 1);
      i = end - 1;
      if (word == "qquad") {
        result.append("\n").append(kIndent);
        while (i + 1 < text.size() && text[i + 1] == ' ') ++i;
      } else if (word == "lvert" || word == "rvert") {
        result += "|";
      } else if (word == "sqrt" && end < text.size() && text[end] == '{') {
        const std::size_t behind = behind_bracket(text, end);
        result.append("√(").append(formula(text.substr(end + 1, behind - end - 2))).append(")");
        i = behind - 1;
      } else if (word == "mathrm" || word == "mathbf" || word == "text") {
        if (i + 1 < text.size() && text[i + 1] == ' ') ++i;
      } else {
        result += word;  // \cos; of "\ " nothing
      }
    } else if ((c == '^' || c == '_') && next >= '0' && next <= '9') {
      const auto digit = static_cast<std::size_t>(next - '0');
      result += c == '^' ? kRaised.at(digit) : kLowered.at(digit);
      ++i;
    } else if (text.substr(i).starts_with("^{-")) {
      result += "⁻";
      i += 2;
      for (; i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9'; ++i)
        result += kRaised.at(static_cast<std::size_t>(text[i + 1] - '0'));
    } else if (c != '{' && c != '}') {
      result += c;
    }
  }
  return result;
}

/// A section's explanation and its "Write:", without picture. Paragraphs, formulas and a table's rows are
/// lines.
std::string task_of(const std::vector<std::string>& lines, const std::string& step) {
  std::string task;
  const std::string heading = fmt::format("### {} ", step);
  bool is_here = false, is_shown = false, begins_line = true;
  for (const std::string& line : lines) {
    if (line.starts_with("#")) is_here = is_shown = line.starts_with(heading);
    if (!is_here || line.starts_with("#") || line.starts_with("![") || line.starts_with("|--")) continue;
    const bool is_bullet = line.starts_with("- "), is_row = line.starts_with("| ");
    if (is_bullet) is_shown = line.starts_with("- **Write:**");
    const bool is_alone = is_bullet || is_row || line.starts_with("$$");
    const std::size_t text = line.find_first_not_of(' ');
    if (!is_shown || text == std::string::npos) {
      begins_line = true;
      continue;
    }
    if (!task.empty()) task += is_bullet ? "\n\n" : begins_line || is_alone ? "\n" : " ";
    task += is_bullet ? line.substr(2) : is_row ? line.substr(2, line.rfind(" |") - 2) : line.substr(text);
    begins_line = is_alone && !is_bullet;
  }
  return without_markdown(task);
}

}  // namespace

std::string without_markdown(std::string_view text) {
  std::string result;
  bool is_code = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '`') {
      is_code = !is_code;
    } else if (c == '$' && !is_code) {
      const std::size_t marks = i + 1 < text.size() && text[i + 1] == '$' ? 2 : 1;
      const std::size_t end = text.find('$', i + marks);
      if (end == std::string_view::npos) {
        result += c;
        continue;
      }
      if (marks == 2) result += kIndent;
      result += formula(text.substr(i + marks, end - i - marks));
      i = end + marks - 1;
    } else if (text.substr(i, 2) == "**" && !is_code) {
      ++i;
    } else if (c == '*' && !is_code && text.substr(std::max<std::size_t>(i, 1) - 1, 3) != " * ") {
      continue;                         // of *a word*
    } else if (c == '[' && !is_code) {  // of a link only its text
      const std::size_t end = text.find(']', i);
      if (end == std::string_view::npos) {
        result += c;
        continue;
      }
      result += without_markdown(text.substr(i + 1, end - i - 1));
      i = end;
      if (i + 1 < text.size() && text[i + 1] == '(') i = std::min(text.find(')', i), text.size() - 1);
    } else {
      result += c;
    }
  }
  return result;
}

StepText read_step_text(const std::filesystem::path& root, const std::string& lab_folder,
                        const std::string& step, const std::string& file, int line) {
  StepText text;
  text.file = root / file, text.shown_file = file, text.line = line, text.first_line = line;
  try {
    const std::vector<std::string> lines = lines_of(read_file(text.file));
    const auto begin = static_cast<std::size_t>(std::max(line, 1)) - 1;
    // From the comment and the head of the function on.
    std::size_t first = std::min(begin, lines.size());
    while (first > 0 && begin - first < kMostBefore && !lines[first - 1].empty() &&
           lines[first - 1].find("//@") == std::string::npos)
      --first;
    text.first_line = static_cast<int>(first) + 1;
    for (std::size_t i = first; i < lines.size(); ++i) {
      if (lines[i].find("//@starter") != std::string::npos || text.lines.size() == kMostLines) break;
      text.lines.push_back(lines[i]);
      if (i >= begin && lines[i].find("//@end") != std::string::npos) break;
    }
  } catch (const Error&) {
    text.lines.clear();  // the file's name still helps
  }
  try {
    text.task = task_of(lines_of(read_file(root / "labs" / lab_folder / "README.md")), step);
  } catch (const Error&) {
    text.task.clear();
  }
  return text;
}

}  // namespace texel::course
