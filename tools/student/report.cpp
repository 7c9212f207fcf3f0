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

/// Written, and not right: its own text is to be changed, whether other steps come first or not.
bool is_wrong(const StepResult& step) {
  return !step.passed() && !step.is_untouched() && !step.was_right;
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

const StepResult* next_step(const LabResult& lab) {
  const StepResult* latest = nullptr;
  for (const StepResult& step : lab.steps)
    if (step.status == Status::failed && is_wrong(step) && (latest == nullptr || step.saved > latest->saved))
      latest = &step;
  if (latest != nullptr) return latest;
  for (const Status status : {Status::failed, Status::skipped})
    for (const StepResult& step : lab.steps)
      if (step.status == status) return &step;
  return nullptr;
}

std::string report(const LabResult& lab) {
  const auto done = std::ranges::count(lab.steps, Status::passed, &StepResult::status);
  std::string text = paint(kBold, fmt::format("Lab {}: {}", lab.lab.number, lab.lab.title)) +
                     fmt::format(", {} of {} steps\n", done, lab.steps.size());
  const StepResult* next = next_step(lab);
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
    if (&step != next && !(is_wrong(step) && !judge::clearest_case(step)->picture.empty())) continue;
    text += paint(kDim, fmt::format("{:12}{}:{}\n", "", step.file, step.line));
    if (&step == next && step.status == Status::skipped) text += fitted(step.message, 12);
    if (is_wrong(step) || step.status != Status::skipped) text += details(step);
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

std::string progress_report(const std::vector<LabResult>& labs) {
  const bool colors = wants_colors();
  std::string text;
  double points = 0, most = 0, hours = 0;
  const LabResult* next = nullptr;
  std::size_t width = 0;
  for (const LabResult& lab : labs) width = std::max(width, lab.lab.title.size());
  const char *done = colors ? "█" : "#", *to_do = colors ? "░" : "-", *waits = colors ? "·" : ".";
  for (const LabResult& lab : labs) {
    std::string bar;
    for (const StepResult& step : lab.steps)
      bar += step.status == Status::passed    ? paint(kGreen, done)
             : step.status == Status::skipped ? waits
                                              : to_do;
    bar += std::string(8 - std::min<std::size_t>(8, lab.steps.size()), ' ');
    text += fmt::format("  {:>2}  {:<{}}  {} {:>3g} of {:g} points\n", lab.lab.number, lab.lab.title, width,
                        bar, lab.points(), lab.max_points());
    points += lab.points(), most += lab.max_points();
    // As docs/course.md estimates.
    if (lab.points() < lab.max_points()) hours += 0.5 + 0.25 * (lab.max_points() - lab.points());
    if (next == nullptr && next_step(lab) != nullptr) next = &lab;
  }
  text += fmt::format("  {:g} of {:g} points; {} done, {} to do, {} waits for another step\n", points, most,
                      paint(kGreen, done), to_do, waits);
  for (const LabResult& lab : labs)
    for (const std::string& copy : lab.lab.copies)
      text += fitted(fmt::format("labs/{} is a copy of lab {}: what is written there does not count.", copy,
                                 lab.lab.number));
  if (next != nullptr)
    text += fmt::format("next: {} {}   ./run watch {}\nWhat is left takes about {}.\n", next_step(*next)->id,
                        next_step(*next)->title, next->lab.number,
                        hours > 1 ? fmt::format("{:.0f} hours", std::ceil(hours)) : "an hour");
  return text;
}

}  // namespace texel::tools
