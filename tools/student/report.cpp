// SPDX-License-Identifier: MIT
#include "student.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "commands.hpp"
#include "core/terminal.hpp"

namespace texel::tools {
namespace {

using judge::CaseResult;
using judge::LabResult;
using judge::Status;
using judge::StepResult;

constexpr const char* kGreen = "\033[32m";
constexpr const char* kYellow = "\033[1;33m";
constexpr const char *kDim = "\033[2m", *kBold = "\033[1m";

/// On standard output: a terminal, and no NO_COLOR.
bool wants_colors() {
  const char* const no = std::getenv("NO_COLOR");
  return ::isatty(STDOUT_FILENO) != 0 && (no == nullptr || *no == '\0');
}

std::string paint(const char* color, const std::string& text) {
  return wants_colors() ? color + text + "\033[0m" : text;
}

/// A case's message: of a compiler's, the first, since the others often follow from it.
std::string short_message(const CaseResult& one) {
  std::string first = one.message.substr(0, one.message.find('\n'));
  constexpr std::string_view kListed = "; candidates are:";  // Mesa lists them below
  if (first.ends_with(kListed)) first.resize(first.size() - kListed.size());
  const auto others = std::count(one.message.begin(), one.message.end(), '\n');
  return first + (others > 0 ? fmt::format("\n{} more: ./run see {}", others, one.step) : "");
}

/// What is wrong with a step, and what helps.
std::string details(const StepResult& step) {
  constexpr std::size_t indent = 12;
  const CaseResult& telling = *judge::clearest_case(step);
  const bool is_drawn = !telling.picture.empty();
  const std::string see = paint(kDim, fmt::format("{:12}see it: ./run see {}\n", "", step.id));
  if (step.is_untouched() && is_drawn)
    return fitted("Not begun. Write your lines there.", indent) + see + prediction(step.id, 0, indent);
  // One fault may be in the way of several cases.
  std::vector<std::pair<std::string, std::string>> names_by_message;
  for (const CaseResult& one : step.cases) {
    const std::string message = one.passed() ? "right" : short_message(one);
    if (names_by_message.empty() || names_by_message.back().second != message)
      names_by_message.emplace_back(one.name, message);
    else
      names_by_message.back().first += ", " + one.name;
  }
  std::string text;
  const bool concerns_all = !is_drawn && names_by_message.size() == 1;  // a shader that does not compile
  for (const auto& [names, message] : names_by_message)
    text += fitted(concerns_all ? message : fmt::format("{}: {}", names, message), indent);
  if (!step.mistake_says.empty())
    text += paint(kYellow, fitted("This looks like: " + step.mistake_says, indent));
  return is_drawn ? text + see : text;
}

/// The command for the lab after this one, or "" after the last.
std::string what_follows(int number) {
  for (const course::Lab& lab : course_labs())
    if (lab.number == number + 1) return fmt::format(" Next: ./run watch {}", lab.number);
  return {};
}

}  // namespace

std::string report(const LabResult& lab) {
  const auto done = std::ranges::count(lab.steps, Status::passed, &StepResult::status);
  std::string text = paint(kBold, fmt::format("Lab {}: {}", lab.lab.number, lab.lab.title)) +
                     fmt::format(", {} of {} steps\n", done, lab.steps.size());
  const StepResult* next = judge::next_step(lab.steps);
  std::string said;  // of the step above
  for (const StepResult& step : lab.steps) {
    const char* word = word_of(step, &step == next);
    std::string line = step.title;
    if (step.status == Status::skipped && &step != next && step.message != said)
      line += fmt::format(": {}", said = step.message);
    const std::string begin = fmt::format("  {:<5}  {}  ", word, step.id);
    line = begin + fitted(line, begin.size()).substr(begin.size());
    text += paint(step.passed() ? kGreen : &step == next ? kYellow : kDim, line);
    // A picture that cannot be drawn is told at the next step: another step's text may be the reason.
    if (&step != next && !(step.is_wrong() && !judge::clearest_case(step)->picture.empty())) continue;
    text += paint(kDim, fmt::format("{:12}{}:{}\n", "", step.file, step.line));
    if (&step == next && step.status == Status::skipped) text += fitted(step.message, 12);
    if (step.is_wrong() || step.status != Status::skipped) text += details(step);
  }
  if (lab.steps.size() < lab.lab.steps.size() && next == nullptr)  // some of them were asked for
    for (const StepResult& step : lab.steps) text += paint(kGreen, "Right.") + "\n" + after_step(step.id);
  else if (next == nullptr)
    text += paint(kGreen, fmt::format("All done: {:g} of {:g} points.", lab.points(), lab.max_points())) +
            what_follows(lab.lab.number) + "\n";
  else
    text += fmt::format("A hint: ./run hint {}\n", next->id);
  for (const std::string& note : lab.notes) text += paint(kDim, fitted(note));
  return text;
}

std::vector<StepResult> all_steps(const std::vector<LabResult>& labs) {
  std::vector<StepResult> all;
  for (const LabResult& lab : labs) std::ranges::copy(lab.steps, std::back_inserter(all));
  return all;
}

std::string progress_report(const std::vector<LabResult>& labs) {
  const bool colors = wants_colors();
  std::string text, table;
  const std::vector<StepResult> all = all_steps(labs);
  const char *done = colors ? "█" : "#", *to_do = colors ? "░" : "-", *waits = colors ? "·" : ".";
  for (const LabResult& lab : labs) {
    text += fmt::format("  {}", lab.lab.number);
    for (const StepResult& step : lab.steps)
      text += step.passed() ? paint(kGreen, done) : step.status == Status::skipped ? waits : to_do;
    table += fmt::format("  {:>2}  {:<28}  {:>3g} of {:g} points\n", lab.lab.number, lab.lab.title,
                         lab.points(), lab.max_points());
  }
  text += fmt::format("\n  {} of {} steps: {} done, {} to do, {} waits for another step\n{}",
                      std::ranges::count_if(all, &StepResult::passed), all.size(), paint(kGreen, done), to_do,
                      waits, table);
  for (const LabResult& lab : labs)
    for (const std::string& copy : lab.lab.copies)
      text += fitted(fmt::format("labs/{} is a copy of lab {}: what is written there does not count.", copy,
                                 lab.lab.number));
  const double hours = std::ceil(judge::hours_left(all));
  if (const StepResult* next = judge::next_step(all))
    text += fmt::format("{}: {} {}\n  ./run watch {}\nWhat is left takes about {}.\n",
                        next->is_wrong() ? "you were at" : "next", next->id, next->title, std::stoi(next->id),
                        hours > 1 ? fmt::format("{:g} hours", hours) : "an hour");
  return text;
}

}  // namespace texel::tools
