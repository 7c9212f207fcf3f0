// SPDX-License-Identifier: MIT
#include "wording.hpp"

#include <fmt/format.h>
#include <sodium.h>

#include <algorithm>
#include <cmath>
#include <ranges>

#include "core/plain_text.hpp"
#include "course/markers.hpp"

namespace texel::reports {

std::string clean(std::string_view text) {
  std::string lines;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\t')
      lines += "  ";
    else if (text[i] != '\r' || (i + 1 < text.size() && text[i + 1] != '\n'))
      lines += text[i];
  return plain_lines(lines);
}

std::string shortened(const std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  // A byte 10xxxxxx goes on with the character before it.
  while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xc0U) == 0x80U) --bytes;
  return text.substr(0, bytes) + "\n… (shortened)";
}

std::string escaped(std::string_view text) {
  std::string cleaned = clean(text);
  // U+FFFE and U+FFFF are UTF-8 but not XML.
  for (const char* character : {"\xEF\xBF\xBE", "\xEF\xBF\xBF"})
    for (std::size_t at = 0; (at = cleaned.find(character, at)) != cleaned.npos;)
      cleaned.replace(at, 3, "\xEF\xBF\xBD");
  constexpr std::string_view special = "&<>\"'";
  constexpr const char* escaped[] = {"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
  std::string result;
  for (const char c : cleaned)
    if (const std::size_t found = special.find(c); found != special.npos)
      result += escaped[found];
    else
      result += c;
  return result;
}

std::string base64(std::string_view bytes) {
  std::string text(sodium_base64_ENCODED_LEN(bytes.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
  ::sodium_bin2base64(text.data(), text.size(), reinterpret_cast<const unsigned char*>(bytes.data()),
                      bytes.size(), sodium_base64_VARIANT_ORIGINAL);
  text.pop_back();  // its zero at the end
  return text;
}

std::string number(double value, int decimals) {
  if (!std::isfinite(value)) return fmt::format("{}", value);
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

std::string counted(std::size_t count, const std::string& what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string cause(const std::string& says) {
  return says.empty() ? "" : fmt::format("This looks like: {}", says);
}

std::string hint(const judge::StepResult& step) {
  if (step.hints.empty()) return "";
  if (step.is_untouched()) return step.hints[0];
  const auto failed = std::ranges::find_if_not(step.cases, &judge::CaseResult::passed);
  for (const auto& [begin, hint] : std::views::reverse(step.hint_of))  // the longest name that fits
    if (failed != step.cases.end() && failed->name.starts_with(begin)) return step.hints[hint - 1];
  const bool is_partly_right = std::ranges::any_of(step.cases, &judge::CaseResult::passed);
  return is_partly_right ? step.hints.back() : step.hints[std::min<std::size_t>(1, step.hints.size() - 1)];
}

std::string distance(const judge::CaseResult& result) {
  // Of a vertex stream the message has its numbers, and what is spoilt elsewhere is not off.
  if (!std::isfinite(result.error) || result.is_mesh() || (!result.passed() && result.error <= result.limit))
    return "";
  return fmt::format("{}{:.3g} {} off; full marks up to {:.3g}", result.is_alone() ? "judged alone, " : "",
                     result.error, name_of(result.unit()), result.limit);
}

std::string judging(const judge::StepResult& step) {
  if (store::is_any(step, judge::Judged::markers_lost))
    return fmt::format(
        "{} was not judged alone, since its line {} or its //@end is missing or changed: copy both from the "
        "folder .starter.",
        step.id, course::begin_marker(step.id));
  if (!store::is_any(step, judge::Judged::alone)) return "";
  const std::string others = step.spoilt_by.empty() ? "the other lines" : judge::listed(step.spoilt_by);
  if (step.status == judge::Status::passed)
    return fmt::format("{} is right: with {} mended it has full marks.", step.id, others);
  return fmt::format("{} was judged with {} mended: the mark is of its own mistake.", step.id, others);
}

std::string place(const judge::StepResult& step) {
  if (step.file.empty() || step.line < 1) return step.file;
  return fmt::format("{}:{}", step.file, step.line);
}

std::string command(const judge::CaseResult& result) {
  return result.hidden && result.reference.empty() ? "" : result.command;
}

std::size_t count(const std::vector<judge::CaseResult>& cases, bool hidden, bool only_failed) {
  return static_cast<std::size_t>(std::ranges::count_if(cases, [&](const judge::CaseResult& result) {
    return result.hidden == hidden && !(only_failed && result.passed());
  }));
}

}  // namespace texel::reports
