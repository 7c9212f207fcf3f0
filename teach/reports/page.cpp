// SPDX-License-Identifier: MIT
#include "page.hpp"

#include <fmt/format.h>

#include <charconv>
#include <string_view>

#include "wording.hpp"

namespace texel::reports {
namespace {

/// "'sha256-…'", as a Content-Security-Policy names a text that it allows.
std::string allowed(const Embedded& text) {
  const std::string_view digits = text.sha256;
  std::string bytes;
  for (std::size_t i = 0; i + 1 < digits.size(); i += 2) {
    unsigned byte = 0;
    std::from_chars(&digits[i], &digits[i] + 2, byte, 16);
    bytes += static_cast<char>(byte);
  }
  return fmt::format("'sha256-{}'", base64(bytes));
}

}  // namespace

std::string page(const std::string& title, const std::string& body, const Embedded& script) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src {}; script-src {}; base-uri 'none'; form-action 'none'\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"referrer\" content=\"no-referrer\">\n"
      "<link rel=\"icon\" href=\"data:,\">\n<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}"
      "<script>{}</script>\n</body>\n</html>\n",
      allowed(kStyle), allowed(script), escaped(title), kStyle.text, body, script.text);
}

std::string command_line(const std::string& command) {
  std::string html = "<span>" + escaped(command) + "</span>";
  for (std::size_t at = html.find(" --"); at != std::string::npos; at = html.find(" --", at + 15))
    html.replace(at, 1, "</span> <span>");
  return fmt::format(
      "<div class=\"command\"><code>{}</code><button type=\"button\" class=\"copy\" "
      "aria-label=\"Copy the command\">Copy</button></div>\n",
      html);
}

std::string facts_list(const std::map<std::string, std::string>& facts, bool with_command) {
  std::string html;
  for (const auto& [name, value] : facts)
    if (name != "command") html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(name), escaped(value));
  if (!html.empty()) html = "<dl class=\"facts\">\n" + html + "</dl>\n";
  if (const auto found = facts.find("command"); with_command && found != facts.end())
    html += "<p>This command grades the same again:</p>\n" + command_line(found->second);
  return html;
}

Standing standing(const judge::StepResult& step) {
  if (step.status == judge::Status::passed) return {"passed", "✓", "passed"};
  if (step.cases.empty()) return {"skipped", "·", "not judged"};
  if (step.is_untouched()) return {"skipped", "–", "not begun"};
  return step.score > 0 ? Standing{"partial", "◐", "not yet, in part"} : Standing{"failed", "✗", "not yet"};
}

}  // namespace texel::reports
