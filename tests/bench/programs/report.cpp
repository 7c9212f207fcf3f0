// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/parallel.hpp"
#include "core/terminal.hpp"

namespace texel::bench {

namespace {

/// Four digits, and no exponent where there are more before the point.
std::string number(double value) {
  return value < 1000 ? fmt::format("{:.4g}", value) : fmt::format("{:.0f}", value);
}

}  // namespace

void Report::begin(const std::string& title, const std::string& text) {
  fmt::print("\n{}\n", title);
  sections_.push_back({title, text, {}, {}});
}

void Report::add(const Row& row) {
  fmt::print("  {:<44} {:8.2f} ({:.2f} to {:.2f})  {}{}\n", row.what, row.ratio.median, row.ratio.lower,
             row.ratio.upper, row.target, row.reached ? "" : "  MISSED");
  flush_output();
  sections_.back().rows.push_back(row);
}

void Report::note(const std::string& text) {
  fmt::print("  {}\n", text);
  sections_.back().notes.push_back(text);
}

std::string Report::as_json() const {
  Json json;
  const auto spread = [](const Spread& s) {
    return Json{{"median", s.median}, {"lower", s.lower}, {"upper", s.upper}};
  };
  for (const Section& section : sections_) {
    for (const std::string& note : section.notes) json["notes"].push_back(note);
    for (const Row& row : section.rows)
      json["results"].push_back({{"section", section.title},
                                 {"what", row.what},
                                 {"unit", row.unit},
                                 {row.ours_is, spread(row.ours)},
                                 {row.theirs_is, spread(row.theirs)},
                                 {"ratio", spread(row.ratio)},
                                 {"target", row.target},
                                 {"reached", row.reached}});
  }
  for (const auto& [name, stages] : stages_) json["stages"][name] = stages;
  return to_text(json, 2) + "\n";
}

std::string Report::as_markdown(int rounds, int long_rounds) const {
  std::string text = fmt::format(
      "# How fast\n\n"
      "Made by `./run performance`, which takes about an hour. All figures are of one machine with {} "
      "processors, taken in turn with what they stand beside in {} rounds (batches, grading and the first "
      "`./run` in {}); the ratio is the median of the rounds, with the quarters below and above it. The "
      "driver's cache of compiled shaders is off (`MESA_SHADER_CACHE_DISABLE=true`) where nothing else is "
      "said. "
      "Speed against *error* is in [accuracy.md](accuracy.md).\n",
      processors(), rounds, long_rounds);
  for (const Section& section : sections_) {
    if (section.rows.empty()) continue;
    text += fmt::format("\n## {}\n{}\n\n", section.title, section.text);
    text += fmt::format("| | {} | {} | ratio | target |\n|---|---|---|---|---|\n", section.rows[0].ours_is,
                        section.rows[0].theirs_is);
    for (const Row& row : section.rows)
      text += fmt::format("| {} | {} {} | {} {} | **{:.3g}** ({:.3g} to {:.3g}) | {}{} |\n", row.what,
                          number(row.ours.median), row.unit, number(row.theirs.median), row.unit,
                          row.ratio.median, row.ratio.lower, row.ratio.upper, row.target,
                          row.reached ? "" : ", **missed**");
    for (const Row& row : section.rows)
      if (!row.reached && !row.why.empty()) text += fmt::format("\n**{}**: {}\n", row.what, row.why);
    for (const std::string& note : section.notes) text += fmt::format("\n{}\n", note);
  }
  if (!stages_.empty()) text += stage_table();
  return text;
}

/// Where each millisecond of a snapshot goes, as --stats says it.
std::string Report::stage_table() const {
  std::string head = "| stage |", rule = "|---|", body;
  std::vector<std::string> names;
  for (const auto& [lab, stages] : stages_) {
    head += fmt::format(" {} |", lab);
    rule += "---|";
    for (const auto& [name, time] : stages.items())
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  }
  // A stage that only some labs have comes before what closes the list.
  std::stable_partition(names.begin(), names.end(), [](const std::string& name) {
    return name != "other" && name != "total" && name != "draw";
  });
  for (const std::string& name : names) {
    body += fmt::format("| {} |", name);
    for (const auto& [lab, stages] : stages_) body += fmt::format(" {:.1f} |", stages.value(name, 0.0));
    body += "\n";
  }
  return "\n## Where a snapshot's milliseconds go\n`labNN --snapshot FILE --stats -`, once. `start` is the "
         "program's own loading, `loader` the renderer's, `first_draw` mostly the driver's translation of "
         "the shaders into machine code: `draw` is the same picture once more, when all is there, and not "
         "part of `total`; its shaders are those of a single picture, which `--frames` optimises.\n\n" +
         head + "\n" + rule + "\n" + body;
}

}  // namespace texel::bench
