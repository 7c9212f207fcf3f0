// SPDX-License-Identifier: MIT
#include "page.hpp"

#include <fmt/format.h>
#include <sodium.h>

#include "core/plain_text.hpp"
#include "material/mutant_file.hpp"
#include "wording.hpp"

namespace texel::reports {
namespace {

/// "'sha256-…'", as a Content-Security-Policy names a text that it allows.
std::string allowed(const Embedded& text) {
  std::string bytes(32, '\0');
  ::sodium_hex2bin(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), text.sha256,
                   2 * bytes.size(), nullptr, nullptr, nullptr);
  return fmt::format("'sha256-{}'", base64(bytes));
}

void clean_texts(Json& value) {
  if (value.is_string()) value = clean(value.get_ref<const std::string&>());
  if (value.is_structured())
    for (Json& part : value) clean_texts(part);
}

/// JSON as it may stand in a <script>: no text in it can end the element, or begin another.
std::string within_script(const Json& data) {
  std::string text;
  for (const char c : to_text(data)) text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return text;
}

constexpr const char* kPage = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; img-src data:; style-src {style_hash}; script-src {script_hash}; base-uri 'none'; form-action 'none'">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="referrer" content="no-referrer">
<link rel="icon" href="data:,">
<title>{title}</title>
<style>{style}</style>
</head>
<body>
<noscript><p>This page is shown by a script of its own: allow JavaScript for it.</p></noscript>
<script type="application/json" id="data">{data}</script>
<script>{script}</script>
</body>
</html>
)";

/// How a step stands: the class of its color, a symbol that tells it without colors, and a word.
struct Standing {
  const char *style, *symbol, *word;
};

Standing standing(const judge::StepResult& step) {
  if (step.status == judge::Status::passed) return {"passed", "✓", "passed"};
  if (step.cases.empty()) return {"skipped", "·", "not judged"};
  if (step.is_untouched()) return {"skipped", "–", "not begun"};
  return step.score > 0 ? Standing{"partial", "◐", "not yet, in part"} : Standing{"failed", "✗", "not yet"};
}

}  // namespace

std::string page(const std::string& title, const Json& data, const Embedded& script) {
  Json cleaned = data;
  clean_texts(cleaned);
  return fmt::format(kPage, fmt::arg("style_hash", allowed(kStyle)), fmt::arg("script_hash", allowed(script)),
                     fmt::arg("title", escaped(title)), fmt::arg("style", kStyle.text),
                     fmt::arg("data", within_script(cleaned)), fmt::arg("script", script.text));
}

Json step_data(const judge::StepResult& step) {
  const auto [style, symbol, word] = standing(step);
  return {{"id", step.id},
          {"title", step.title},
          {"style", style},
          {"symbol", symbol},
          {"word", word},
          {"score", step.score},
          {"earned", number(step.points * step.score)},
          {"points", number(step.points)},
          {"mistake", mistake_data(step.mistake, step.mistake_says)},
          {"overridden", step.overridden}};
}

Json mistake_data(const std::string& name, const std::string& says) {
  if (says.empty()) return nullptr;
  const std::string title = material::title_of(says);
  std::string own = name;  // what is not in the catalogue is called as it is said, without its numbers
  for (const char c : name.empty() ? lower_case(title) : std::string())
    if (c >= 'a' && c <= 'z')
      own += c;
    else if (c == ' ')
      own += '-';
  return {{"name", own}, {"title", title}, {"rest", says.substr(title.size())}};
}

}  // namespace texel::reports
