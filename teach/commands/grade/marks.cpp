// SPDX-License-Identifier: MIT
#include "grade/marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/terminal.hpp"
#include "course_commands.hpp"
#include "renderers/table.hpp"

namespace texel::commands {
namespace {

/// How many times further off than any right answer the smallest mistake of a step must be.
constexpr double kApart = 3;

void print_now(const std::string& line) {
  fmt::print("{}\n", line);
  flush_output();
}

grade::Spreads spreads_of(const std::filesystem::path& file) {
  grade::Spreads spreads;
  for (const RendererReport::Row& row : read_renderers(file).cases) spreads[{row.lab, row.name}] = row.most();
  return spreads;
}

std::string figure(double value) {
  return std::isfinite(value) ? fmt::format("{:.2g}", value) : "nothing to compare";
}

std::string cell(const grade::Far& far) {
  return fmt::format("{} {} of {:g} | {} | {}", figure(far.error), far.unit, far.limit,
                     figure(far.times_limit), far.by);
}

constexpr const char* kHead = R"(# Right answers and mistakes

A right answer must never lose a mark, and a mistake must always lose some. The table has both sides of each step: the right
answer that is furthest from the expected picture, on any renderer or written another way, and the smallest mistake of the
catalogue. Both are given in the case where they are furthest off, with the case's limit and as a share of it. The mistake
is off at least three times as far. The last column is the best mark that a mistake of this step gets.

`./run marks` judges each mutant and each equivalent, and the solution with each place of a step as the starter has it, with
several seeds. It fails when a mistake passes, when a right answer fails, or when they are less than three times apart.
`./run marks --list` prints all of them.

| step | furthest right answer | times the limit | which | smallest mistake | times the limit | which | apart | best mark |
| --- | --- | --- | --- | --- | --- | --- | --- | --- |
)";

std::string row_of(const grade::StepMarks& of) {
  const grade::Far none{"all are the same", 0, 0, 0, "", "", 1};
  const grade::Far& right =
      of.rights.empty() || of.rights.front().times_limit <= 0 ? none : of.rights.front();
  const auto best = std::max_element(of.mistakes.begin(), of.mistakes.end(),
                                     [](const auto& a, const auto& b) { return a.mark < b.mark; });
  return fmt::format("| {} | {} | {} | {} | {:.2g} |\n", of.step,
                     &right == &none ? "0 | 0 | " + right.by : cell(right), cell(of.mistakes.front()),
                     std::isfinite(of.apart()) ? figure(of.apart()) : "", best->mark);
}

}  // namespace

Exit marks(const MarksCommand& command) {
  const std::filesystem::path root = tools::course_root();
  std::vector<std::string> faults;
  const std::vector<grade::StepMarks> all = grade::marks_of(
      {root, tools::course_build(), command.cache.empty() ? root / "build/grade" : command.cache,
       tools::chosen_labs(command.labs)},
      command.seeds, command.places, spreads_of(root / "docs/renderers.json"), faults, print_now);
  std::string table = kHead;
  for (const grade::StepMarks& of : all) {
    if (of.apart() < kApart)
      faults.push_back(
          fmt::format("{}: '{}' is {:.3g} times as far off as '{}', which is right; not {} times", of.step,
                      of.mistakes.front().by, of.apart(), of.rights.front().by, kApart));
    if (of.mistakes.empty())
      faults.push_back(fmt::format("{}: the catalogue has no mistake of this step", of.step));
    else
      table += row_of(of);
    if (!command.list) continue;
    for (const std::vector<grade::Far>* side : {&of.rights, &of.mistakes})
      for (const grade::Far& far : *side)
        print_now(fmt::format("{} {} mark {:.3f}, {} times the limit in {}: {}", of.step,
                              side == &of.rights ? "right  " : "mistake", far.mark, figure(far.times_limit),
                              far.at, far.by));
  }
  if (!command.markdown.empty())
    write_file(command.markdown, table);
  else if (!command.list)
    print_now(table);
  for (const std::string& fault : faults) print_now(fault);
  return faults.empty() ? Exit::holds : Exit::differs;
}

}  // namespace texel::commands
