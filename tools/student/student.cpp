// SPDX-License-Identifier: MIT
// The commands with which a student goes from step to step.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <future>

#include "captions.hpp"
#include "commands.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "core/terminal.hpp"
#include "course/markers.hpp"
#include "course/step_text.hpp"
#include "image/save.hpp"
#include "judge/results.hpp"
#include "student.hpp"

namespace texel::tools {
namespace {

namespace fs = std::filesystem;

/// Whether a step of these labs was changed by the student.
bool is_begun(const std::vector<judge::LabResult>& labs) {
  return std::ranges::any_of(labs, [](const judge::LabResult& lab) {
    return !std::ranges::all_of(lab.steps, &judge::StepResult::is_untouched);
  });
}

const course::Step& step_called(const std::string& id) {
  static const std::vector<course::Lab> labs = course_labs();
  std::vector<std::string> known;
  for (const course::Lab& lab : labs)
    for (const course::Step& step : lab.steps) {
      if (step.id == id) return step;
      known.push_back(step.id);
    }
  throw Error::usage(fmt::format("there is no step '{}'", id),
                     fmt::format("the steps are {}", fmt::join(known, ", ")));
}

course::StepText handout_of(const std::string& step) {
  step_called(step);
  const course::Lab lab = chosen_labs({std::stoi(step)}).front();
  return course::read_step_text(course_root(), lab.folder, step, {}, 0);
}

/// Labs as "9" and steps as "9.4"; all labs for none. Of a lab whose steps are named it has these alone.
std::vector<judge::LabResult> check_places(const std::vector<std::string>& places,
                                           const std::string& context) {
  std::vector<int> numbers;
  for (const std::string& place : places)
    numbers.push_back(std::stoi(place.find('.') == place.npos ? place : step_called(place).id));
  std::vector<judge::LabResult> labs = checked(chosen_labs(numbers), context);
  const auto is_named = [&](const std::string& place) { return std::ranges::count(places, place) > 0; };
  for (judge::LabResult& lab : labs)
    if (!places.empty() && !is_named(std::to_string(lab.lab.number)))
      std::erase_if(lab.steps, [&](const judge::StepResult& step) { return !is_named(step.id); });
  return labs;
}

}  // namespace

check::OwnTree own_tree() {
  return {course_root(), course_build()};
}

std::vector<judge::LabResult> checked(const std::vector<course::Lab>& labs, const std::string& context) {
  auto work =
      std::async(std::launch::async, check::check, own_tree(), labs, check::by_programs(own_tree(), context));
  constexpr std::chrono::seconds kQuiet{5};  // a check of all nine labs takes 1 s on two processors
  if (work.wait_for(kQuiet) == std::future_status::timeout && ::isatty(STDERR_FILENO) != 0)
    std::fputs("still drawing; a program that does not end is stopped\n", stderr);
  return work.get();
}

std::string prediction(const std::string& step, std::size_t choice, std::size_t indent) {
  const course::StepText text = handout_of(step);
  if (text.question.empty()) return {};
  if (choice > text.answers.size())
    throw Error::usage(fmt::format("there is no answer {}", choice), "choose one of the numbers");
  std::string said = fitted(text.question, indent);
  for (std::size_t i = 0; i < text.choices.size(); ++i)
    if (choice == 0 || choice == i + 1) said += fitted(fmt::format("{} {}", i + 1, text.choices[i]), indent);
  return said + fitted(choice == 0 ? fmt::format("Your answer: ./run predict {} 1, 2 or 3", step)
                                   : text.answers[choice - 1],
                       indent);
}

std::string after_step(const std::string& step) {
  const std::string after = handout_of(step).after;
  return after.empty() ? "" : fitted(fmt::format("{}: {}", step, after));
}

std::string next_hint(const course::Step& step) {
  const fs::path file = course_build() / "check/hints.json";
  // A broken file counts as none. Only the number of shown hints is lost.
  Json shown = fs::exists(file) ? json_or_null(read_file(file)) : Json();
  if (!shown.is_object()) shown = Json::object();
  const Json known = shown.value(step.id, Json());
  const std::size_t before = known.is_number_unsigned() ? known.get<std::size_t>() : 0;
  const std::size_t count = std::min(before + 1, step.hints.size());
  shown[step.id] = count;
  make_folder(file.parent_path());
  write_file(file, to_text(shown, 1) + "\n");
  std::string text = fitted(fmt::format("Step {}: {}", step.id, step.title));
  for (std::size_t i = 0; i < count; ++i)
    text += fitted(fmt::format("hint {} of {}: {}", i + 1, step.hints.size(), step.hints[i]), 2);
  if (before == step.hints.size()) text += "  This was the last hint.\n";
  return text;
}

Exit check(const CheckOptions& options, const std::string& context) {
  const std::vector<judge::LabResult> labs = check_places(options.places, context);
  if (options.json)
    fmt::print("{}\n", options.places.size() == 1 ? to_json(labs.front()) : to_json(labs));
  else
    for (const judge::LabResult& lab : labs)
      fmt::print("{}{}", &lab == &labs.front() ? "" : "\n", report(lab));
  if (judge::next_step(all_steps(labs)) == nullptr || (options.unless_begun && !is_begun(labs)))
    return Exit::holds;
  return Exit::differs;
}

Exit see(const std::string& wanted, fs::path out, const std::string& context) {
  step_called(wanted);
  const judge::LabResult lab = check_places({wanted}, context).front();
  const judge::StepResult& step = lab.steps.front();
  const judge::CaseResult& one = *judge::clearest_case(step);  // each step has a case
  fmt::print("{}", fitted(fmt::format("{} {}, {}: {}", step.id, step.title, one.name,
                                      one.passed() ? "right" : one.message)));
  if (!one.mistake_says.empty()) fmt::print("{}", fitted("This looks like: " + one.mistake_says));
  if (one.picture.empty()) return Exit::failed;  // the message says why
  if (one.is_mesh()) {
    fmt::print("This case compares vertices. Your model beside the right one:\n./run lab {} --see {}\n",
               lab.lab.number, step.id);
    return Exit::holds;
  }
  if (out.empty()) out = course_root() / "out/see" / (step.id + ".png");
  make_folder(out.parent_path());
  image::save_png(out, with_captions(check::compared(one), one.unit()), {}, 6);
  fmt::print("Your picture, the expected one, and where they differ:\n{}\n", out.string());
  return Exit::holds;
}

Exit progress(const std::string& context) {
  fmt::print("{}", progress_report(checked(course_labs(), context)));
  return Exit::holds;
}

Exit hint(const std::string& where, const std::string& context) {
  std::string id = where;
  if (id.find('.') == id.npos) {
    const std::vector<judge::StepResult> steps =
        all_steps(check_places(id.empty() ? std::vector<std::string>() : std::vector{id}, context));
    const judge::StepResult* next = judge::next_step(steps);
    if (next == nullptr) {
      fmt::print("{}", id.empty() ? "All steps are done.\n" : "All steps of this lab are done.\n");
      return Exit::holds;
    }
    id = next->id;
  }
  fmt::print("{}", next_hint(step_called(id)));
  return Exit::holds;
}

Exit predict(const std::string& step, std::size_t choice) {
  fmt::print("{}", prediction(step, choice, 0));
  return Exit::holds;
}

Exit reset(const std::string& step) {
  step_called(step);
  const fs::path root = course_root();
  if (!fs::exists(root / course::kFirstTexts))
    throw Error::usage("this is the course's own tree: its steps are solved",
                       "write a student's tree with 'texel starter --out DIR'");
  bool changed = false;
  for (const std::string& file : course::step_files(root)) {
    const std::string first = course::first_text(root, file);
    if (!course::step_texts(first).contains(step)) continue;
    const std::string own = read_file(root / file), text = course::with_step_from(own, file, step, first);
    if (text == own) continue;
    // What was written is kept, under the first free name.
    fs::path kept = (root / file).string() + ".before-reset";
    for (int i = 2; fs::exists(kept); ++i)
      kept = fmt::format("{}.before-reset-{}", (root / file).string(), i);
    write_file(kept, own);
    write_file(root / file, text);
    fmt::print("{}", fitted(fmt::format("{}: step {} has its starting code again; your code is in {}", file,
                                        step, kept.lexically_relative(root).generic_string())));
    changed = true;
  }
  if (!changed) fmt::print("step {} already has its starting code\n", step);
  return Exit::holds;
}

}  // namespace texel::tools
