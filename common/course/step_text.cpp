// SPDX-License-Identifier: MIT
#include "course/step_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/pattern.hpp"
#include "core/plain_text.hpp"
#include "course/markers.hpp"

namespace texel::course {
namespace {

constexpr std::size_t kMostBefore = 6;  // lines of the function's head

/// Of formulas that stand in lines of their own.
constexpr const char* kIndent = "   ";

/// LaTeX as the handouts use it, in Unicode; where it has a wide gap begins another line.
std::string formula(std::string text) {
  static const Pattern kRoot(R"(\\sqrt\{(([^{}]|\{[^{}]*\})*)\})");
  static const Pattern kWords(R"(\\qquad *|\\[lr]vert|\\(?:mathrm|mathbf|text) ?|\^\{-)");
  const auto root = [](const Pattern::Groups& found) { return "√(" + found[1] + ")"; };
  const auto word = [](const Pattern::Groups& found) -> std::string {
    if (found[0].starts_with("\\qquad")) return std::string("\n") + kIndent;
    return found[0].ends_with("vert") ? "|" : found[0] == "^{-" ? "⁻^" : "";
  };
  text = kWords.replace(text, word);
  for (std::string before; before != text;) text = kRoot.replace(before = text, root);  // a root in a root
  constexpr std::array kRaised = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  constexpr std::array kLowered = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
  constexpr std::string_view kDigits = "0123456789", kDropped = "\\{}";
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::size_t digit = kDigits.find(text[i + 1]);  // behind the last one stands '\0'
    if ((text[i] == '^' || text[i] == '_') && digit != kDigits.npos)
      result += text[i++] == '^' ? kRaised.at(digit) : kLowered.at(digit);
    else if (kDropped.find(text[i]) == kDropped.npos)
      result += text[i];
  }
  return result;
}

/// Takes a step's section of the handout apart, without picture. Paragraphs, formulas and a table's rows are
/// lines.
void read_section(const std::vector<std::string>& lines, const std::string& step, StepText& text) {
  const std::string heading = fmt::format("### {} ", step);
  std::string* part = nullptr;                // that the line belongs to
  std::vector<std::string>* items = nullptr;  // that a numbered line begins one of
  bool is_here = false, begins_line = true;
  for (const std::string& line : lines) {
    if (line.starts_with("#")) part = (is_here = line.starts_with(heading)) ? &text.task : nullptr;
    if (!is_here || line.starts_with("#") || line.starts_with("![") || line.starts_with("|--")) continue;
    const bool is_fold = line.starts_with("<details>"), is_after = line.find("After") != line.npos;
    const bool is_bullet = line.starts_with("- "), is_row = line.starts_with("| ");
    const bool is_item = items != nullptr && line.size() > 2 && line.substr(1, 2) == ". ";
    if (line.starts_with("- **")) part = line.starts_with("- **W") ? &text.task : nullptr;  // where and what
    if (line.starts_with("**Predict:**")) part = &text.question, items = &text.choices;
    if (is_fold) part = is_after ? &text.after : nullptr, items = is_after ? nullptr : &text.answers;
    if (line == "</details>") part = nullptr, items = nullptr;
    if (is_item) part = &items->emplace_back();
    const bool is_alone = is_bullet || is_row || is_item || line.starts_with("$$");
    const std::size_t begin = line.find_first_not_of(' ');
    if (part == nullptr || is_fold || begin == std::string::npos) {
      begins_line = true;
      continue;
    }
    if (!part->empty()) *part += is_bullet ? "\n\n" : begins_line || is_alone ? "\n" : " ";
    *part += is_bullet ? line.substr(2)
             : is_item ? line.substr(3)
             : is_row  ? line.substr(2, line.rfind(" |") - 2)
                       : line.substr(begin);
    begins_line = is_alone && !is_bullet && !is_item;
  }
  for (std::string* one : {&text.task, &text.question, &text.after}) *one = without_markdown(*one);
  for (auto* list : {&text.choices, &text.answers})
    for (std::string& one : *list) one = without_markdown(one);
}

}  // namespace

std::string without_markdown(const std::string& text) {
  // Code, a formula in a line of its own, another one, a link, a product, and what marks words.
  static const Pattern kMarks(
      R"(`([^`]*)`|\$\$([^$]*)\$\$|\$([^$]*)\$|\[([^\]]*)\](?:\([^)]*\))?|( \* )|\*+)");
  return kMarks.replace(text, [](const Pattern::Groups& found) {
    const std::string indent = found[0].starts_with("$$") ? kIndent : "";
    return found[1] + found[5] + indent + formula(found[2] + found[3]) + without_markdown(found[4]);
  });
}

StepText read_step_text(const std::filesystem::path& root, const std::string& lab_folder,
                        const std::string& step, const std::string& file, int line) {
  StepText text;
  text.file = root / file, text.shown_file = file, text.line = line;
  try {
    const std::string all = read_file(text.file);
    const std::vector<std::string> lines = lines_of(all);
    for (const StepPart& part : parts_of(all)) {
      if (part.step != step || !part.is_whole()) continue;
      const auto begin = static_cast<std::size_t>(part.line) - 1;
      // From the comment and the head of the function on.
      std::size_t first = begin;
      while (first > 0 && begin - first < kMostBefore && !lines[first - 1].empty() &&
             lines[first - 1].find("//@") == std::string::npos)
        --first;
      for (std::size_t i = first; i <= begin || !is_marker(lines[i]); ++i)  // a whole part has an end
        text.lines.push_back({static_cast<int>(i) + 1, lines[i], i <= begin});
    }
  } catch (const Error&) {
    text.lines.clear();  // the file's name still helps
  }
  try {
    read_section(lines_of(read_file(root / "labs" / lab_folder / "README.md")), step, text);
  } catch (const Error&) {
    text.task.clear();  // the lines still help
  }
  return text;
}

}  // namespace texel::course
