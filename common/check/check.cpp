// SPDX-License-Identifier: MIT
#include "check/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "course/lab_file.hpp"
#include "course/markers.hpp"
#include "dependencies.hpp"
#include "image/load.hpp"
#include "judge/mistakes.hpp"

namespace texel::check {
namespace {

namespace fs = std::filesystem;
using course::Case;

/// Larger than any picture or vertex stream that can be right.
constexpr std::uintmax_t kMostBytes = 64U << 20U;

/// Where the tree's own pictures of the last check lie, and what is remembered of earlier ones: one build may
/// serve several trees (TEXEL_ROOT), and whoever shows a picture does so when another tree is checked
/// already.
fs::path checked_folder(const OwnTree& tree) {
  const std::string name = fs::weakly_canonical(tree.source).string();
  return tree.build / "check" / fmt::format("{:016x}", std::hash<std::string>()(name));
}

/// A file with steps. Throws Error (exit 3) where it is not.
std::string own_text(const fs::path& source, const std::string& file) {
  if (!fs::exists(source / file))
    throw Error::failed("is missing; it has steps", {(source / file).string()},
                        fmt::format("if it was renamed or moved, put it back; its first text is {}/{}",
                                    course::kFirstTexts, file));
  return read_file(source / file);
}

/// What stands between each step's markers, as far as they are whole.
std::map<std::string, std::string> texts_of_steps(const fs::path& source) {
  std::map<std::string, std::string> texts;
  for (const std::string& file : course::step_files(source))
    for (const auto& [step, text] : course::step_texts(own_text(source, file))) texts[step] += text;
  return texts;
}

std::string text_at(const std::map<std::string, std::string>& texts, const std::string& key) {
  const auto found = texts.find(key);
  return found == texts.end() ? "" : found->second;
}

/// The step that a line is of, as "labs/03_obj_texcoords/clip_ears.cpp:41": the last one in its file that
/// begins above it, else the first; "" for any other file.
std::string step_at(const fs::path& source, const std::string& line) {
  std::string found;
  int nearest = 0;
  for (const auto& [step, place] : course::step_places(source)) {
    if (!line.starts_with(place.file + ":")) continue;
    const int above = place.line <= std::stoi(line.substr(place.file.size() + 1)) ? place.line : 0;
    if (found.empty() || above > nearest) found = step, nearest = above;
  }
  return found;
}

/// What became of one lab's cases.
struct CheckedCases {
  std::vector<judge::CaseResult> results;
  std::string renderer;  ///< what drew, or "" where nothing was drawn
};

/// Draws a lab's cases into the folder `own`. A picture of the last check stays until its new one takes its
/// place: somebody may look at it.
Drawn draw_all(const course::Lab& plan, const Draws& draws, const fs::path& own, unsigned processes) {
  std::vector<std::vector<Case>> parts(std::min<std::size_t>(processes, plan.cases.size()));
  for (std::size_t i = 0; i < plan.cases.size(); ++i) parts[i % parts.size()].push_back(plan.cases[i]);
  std::vector<Drawn> drawn(parts.size());
  in_parallel(processes, parts.size(), [&](std::size_t i) { drawn[i] = draws(plan, parts[i], own); });
  Drawn all;
  for (Drawn& part : drawn) {
    all.faults.merge(part.faults);
    all.refused.merge(part.refused);
    all.crashed_at.merge(part.crashed_at);
    if (!part.renderer.empty()) all.renderer = part.renderer;
  }
  for (const auto& [file, fault] : all.faults)
    while (fs::remove(own / file)) continue;  // Emscripten's file system may have an older one below it
  return all;
}

/// Checks a lab by so many processes side by side: nearly all of the time goes into compiling shaders.
CheckedCases check_cases(const OwnTree& tree, const course::Lab& plan, const std::set<std::string>& untouched,
                         const Draws& draws, unsigned processes) {
  const fs::path expected = expected_folder(tree.source, plan), own = checked_folder(tree) / plan.folder;
  if (!fs::exists(expected))
    throw Error::failed("is missing; it contains the expected pictures", {expected.string()},
                        "copy the folder from the course again; the course draws it with ./run expected");
  fs::create_directories(own);
  // A window and a watch may check the same lab.
  const Descriptor lock = lock_file(own.string() + ".lock");
  const Drawn drawn = draw_all(plan, draws, own, processes);
  std::vector<judge::CaseResult> results;
  std::map<std::string, std::map<std::string, judge::Failed>> failed;  // by step and case
  for (const Case& one : plan.cases) {
    const fs::path mask = one.is_mesh() ? fs::path() : expected / (one.name + ".mask.png");
    judge::CaseResult& result = results.emplace_back(judge::CaseResult{one});
    result.command = course::command(plan, one);
    result.reference = (expected / one.file).string();
    if (fs::exists(own / one.file)) result.picture = (own / one.file).string();
    judge::resolve(result, judge(one, {result.reference, mask}, own / one.file),
                   text_at(drawn.faults, one.file), untouched.contains(one.step));
    result.score = result.passed() ? 1 : 0;
    result.died = drawn.faults.contains(one.file) && !drawn.refused.contains(one.file);
    if (result.died) result.crashed_in = step_at(tree.source, text_at(drawn.crashed_at, one.file));
    if (result.passed() || untouched.contains(one.step)) continue;
    judge::Failed seen{picture_bytes(own / one.file), text_at(drawn.refused, one.file),
                       read_file(expected / one.file), mask.empty() ? "" : read_file(mask)};
    if (!seen.picture.empty() || !seen.refused.empty()) failed[one.step][one.name] = std::move(seen);
  }
  const std::vector<judge::Mistake> mistakes = known_mistakes(expected);
  for (const auto& [step, of_step] : failed) {
    const std::map<std::string, judge::Seen> seen = judge::explain(mistakes, plan, step, of_step);
    for (judge::CaseResult& result : results)
      if (const auto one = seen.find(result.name); one != seen.end())
        result.mistake = one->second.mistake, result.mistake_says = one->second.says;
  }
  return {std::move(results), drawn.renderer};
}

/// What drew the expected pictures, or "".
std::string expected_by(const fs::path& source, const course::Lab& lab) {
  const fs::path file = expected_folder(source, lab) / kRendererFile;
  const std::string text = fs::exists(file) ? read_file(file) : "";
  return text.substr(0, text.find_first_of("\r\n"));
}

/// Says where each step is written and when that was saved, and in the labs' notes which steps have damaged
/// markers.
void add_places(const fs::path& source, std::vector<judge::LabResult>& labs) {
  for (const std::string& file : course::step_files(source)) {
    const std::string first = course::first_text(source, file), text = read_file(source / file);
    for (const auto& [step, fault] : course::marker_faults(text, first, file))
      for (judge::LabResult& lab : labs)
        if (std::stoi(step) == lab.lab.number) lab.notes.push_back(fault);
    const std::map<std::string, std::string> steps = course::step_texts(text);
    const std::int64_t saved = fs::last_write_time(source / file).time_since_epoch().count();
    for (judge::LabResult& lab : labs)
      for (judge::StepResult& step : lab.steps)
        if (steps.contains(step.id)) step.saved = std::max(step.saved, saved);
  }
  judge::put_places(labs, course::step_places(source));
}

}  // namespace

std::vector<judge::Mistake> known_mistakes(const fs::path& expected) {
  const fs::path file = expected / kMistakesFile;
  if (!fs::exists(file))
    throw Error::failed("is missing; it contains what known mistakes look like", {file.string()},
                        "copy the file from the course again; the course writes it with ./run expected");
  return judge::parse_mistakes(read_file(file), file.string());
}

judge::Verdict judge(const course::Case& of, const ExpectedFiles& expected, const fs::path& picture) {
  const MappedFile reference(expected.reference);
  std::optional<MappedFile> mask, own;
  if (!expected.mask.empty()) mask.emplace(expected.mask);
  if (fs::is_regular_file(fs::symlink_status(picture))) own.emplace(picture);
  return judge::judge(of, {reference.bytes(), mask ? mask->bytes() : std::string_view()},
                      own ? std::optional(own->bytes()) : std::nullopt);
}

std::string picture_bytes(const fs::path& picture) {
  if (!fs::is_regular_file(fs::symlink_status(picture)) || fs::file_size(picture) > kMostBytes) return {};
  return read_file(picture);
}

image::Compared compared(const judge::CaseResult& one) {
  if (one.is_mesh()) throw Error::failed("this case compares vertices, not pictures");
  if (one.picture.empty()) throw Error::failed("your picture is missing: " + one.message);
  // What renderers differ by is dark.
  const double scale = judge::kNothingLeft * one.limit;
  if (one.view == course::View::color)
    return image::compared(image::load8(one.picture, 3), image::load8(one.reference, 3), scale, one.error);
  return image::compared(image::load_pfm(one.picture), image::load_pfm(one.reference), scale, one.error,
                         name_of(one.view), one.unit() == course::Unit::degrees);
}

fs::path expected_folder(const fs::path& source, const course::Lab& lab) {
  return source / "labs" / lab.folder / "expected";
}

bool is_software(const std::string& renderer) {
  constexpr std::array kNames = {"llvmpipe",   "softpipe", "lavapipe", "swrast", "Software Rasterizer",
                                 "SwiftShader"};
  return std::ranges::any_of(kNames, [&](const char* name) { return renderer.find(name) != renderer.npos; });
}

std::string renderer_note(const std::string& own, const std::string& expected) {
  if (!is_software(own))
    return fmt::format(
        "Drawn by {}, which seems to be a GPU. By one, a right step may fail: install "
        "libgl1-mesa-dri and type LIBGL_ALWAYS_SOFTWARE=1 before the command.",
        own);
  if (expected.empty() || expected == own) return fmt::format("Drawn by {}.", own);
  return fmt::format("Your pictures are drawn by {}, the expected ones by {}. The limits allow for both.",
                     own, expected);
}

std::set<std::string> untouched_steps(const OwnTree& tree) {
  std::set<std::string> steps;
  for (const std::string& file : course::step_files(tree.source)) {
    const std::string text = own_text(tree.source, file);
    steps.merge(course::untouched_steps(text, course::first_text(tree.source, file)));
  }
  return steps;
}

std::vector<judge::LabResult> check(const OwnTree& tree, const std::vector<course::Lab>& labs,
                                    const Draws& draws) {
  std::vector<course::Lab> plans;
  for (const course::Lab& lab : labs) plans.push_back(course::with_public_cases(lab));
  const std::set<std::string> untouched = untouched_steps(tree);
  const std::map<std::string, std::string> texts = texts_of_steps(tree.source);
  std::vector<CheckedCases> found(plans.size());
  const auto at_once = static_cast<unsigned>(std::min<std::size_t>(processors(), plans.size()));
  in_parallel(processors(), plans.size(), [&](std::size_t i) {
    found[i] = check_cases(tree, plans[i], untouched, draws, processors() / at_once);
  });
  std::vector<judge::CaseResult> cases;
  for (const CheckedCases& of_lab : found)
    cases.insert(cases.end(), of_lab.results.begin(), of_lab.results.end());
  std::vector<judge::LabResult> results = judge::lab_results(labs, std::move(cases));
  const fs::path memory = checked_folder(tree) / "passed.json";
  {
    const Descriptor lock = lock_file(memory.string() + ".lock");
    const auto changed = changed_since_it_passed(memory, texts, results);
    for (judge::LabResult& lab : results) skip_those_that_wait(lab, changed);
  }
  for (std::size_t i = 0; i < results.size(); ++i)
    if (!found[i].renderer.empty())
      results[i].notes.push_back(renderer_note(found[i].renderer, expected_by(tree.source, labs[i])));
  add_places(tree.source, results);
  for (judge::LabResult& lab : results)
    for (const std::string& copy : lab.lab.copies)
      lab.notes.push_back(
          fmt::format("labs/{} is a copy of this lab: what is written there does not count.", copy));
  return results;
}

judge::LabResult check_step(const OwnTree& tree, const course::Lab& lab, const std::string& step,
                            const Draws& draws) {
  course::Lab plan = course::with_public_cases(lab);
  std::erase_if(plan.cases, [&](const Case& one) { return one.step != step; });
  if (plan.cases.empty()) throw Error::usage(fmt::format("this lab has no step '{}'", step));
  std::vector<judge::LabResult> results =
      judge::lab_results({lab}, check_cases(tree, plan, untouched_steps(tree), draws, processors()).results);
  std::erase_if(results.front().steps, [&](const judge::StepResult& one) { return one.id != step; });
  add_places(tree.source, results);
  return results.front();
}

std::vector<fs::path> edited_files(const fs::path& source, const course::Lab& lab) {
  static const std::set<std::string> kEndings = {".cpp", ".hpp", ".glsl", ".vert", ".frag"};
  std::vector<fs::path> files;
  for (const fs::path& folder :
       {source / "labs" / lab.folder, source / "shaders" / lab.folder, source / "shaders/lib"})
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      if (entry.is_regular_file() && kEndings.contains(entry.path().extension())) files.push_back(entry);
  return files;
}

}  // namespace texel::check
