// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cache.hpp"
#include "check/check.hpp"
#include "class_run.hpp"
#include "core/files.hpp"
#include "core/plain_text.hpp"
#include "course/markers.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;
using course::Case;

std::string first_error(const std::string& log) {
  std::size_t at = log.find("error:");
  if (at == log.npos) at = log.find("undefined reference");
  if (at == log.npos) at = 0;
  const std::size_t begin = log.rfind('\n', at) + 1;
  return log.substr(begin, log.find('\n', at) - begin);
}

/// The steps that a student began in a file.
std::set<std::string> begun(const ClassSetup& setup, const std::string& path, const std::string& text) {
  const std::string first = read_file(setup.starter.source / path);
  const std::set<std::string> untouched = course::untouched_steps(text, first);
  std::set<std::string> steps;
  for (const auto& [step, given] : course::step_texts(first))
    if (!untouched.contains(step)) steps.insert(step);
  return steps;
}

/// What macOS and Windows put beside files.
bool is_of_system(const std::string& path) {
  const std::string name = path.substr(path.rfind('/') + 1);
  return ("/" + path + "/").find("/__MACOSX/") != path.npos || name.starts_with("._") ||
         name == ".DS_Store" || name == "Thumbs.db" || name == "desktop.ini";
}

}  // namespace

StudentRun::StudentRun(const ClassSetup& setup, const GradeOptions& options, const Entry& entry,
                       fs::path folder)
    : setup_(setup),
      options_(options),
      folder_(std::move(folder)),
      submission_(unpack(entry, setup.allowed,
                         [&](const std::string& file) { return read_file(setup.starter.source / file); })) {
  for (const auto& [path, text] : submission_.files) begun_.merge(begun(setup, path, text));
  for (const auto& [path, text] : submission_.files) digest_ = fingerprint({digest_, path, text});
  digest_ = fingerprint({digest_, submission_.fault});
  fs::remove_all(folder_);
  make_root(setup.starter.source, submission_.files, folder_ / "root");
}

judge::Failed StudentRun::failed_by(const course::Lab& plan, const Files& refused, const Case& of,
                                    const fs::path& out) const {
  const auto found = refused.find(of.file);
  const check::ExpectedFiles files = setup_.course->expected(plan, of);
  return {check::picture_bytes(out / of.file), found == refused.end() ? "" : found->second,
          read_file(files.reference), files.mask.empty() ? "" : read_file(files.mask)};
}

check::Studio StudentRun::studio(const Program& program, const fs::path& root) const {
  check::Studio studio{
      program.file, root, options_.context, options_.run, {setup_.starter.source / "assets"}};
  studio.budget = &budget_;
  if (fs::exists(setup_.models)) studio.readable.push_back(setup_.models);
  return studio;
}

StudentRun::~StudentRun() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

/// The starter has the same file (by its size), or ./run, an editor or git made it there.
bool StudentRun::is_of_course(const std::string& path) const {
  if (!path.starts_with(submission_.root)) return false;
  const std::string below = path.substr(submission_.root.size());
  for (const std::string folder : {"build", "out", ".starter", ".devcontainer", ".git", ".vscode", ".cache"})
    if (below == folder || below.starts_with(folder + "/")) return true;
  const auto given = setup_.given.find(lower_case(below));
  const auto size = submission_.sizes.find(path);  // none of a file that was taken at first
  // Reset and update count what they keep, as in .before-reset-2.
  return below.find(".before-reset") != std::string::npos || below.starts_with(".before-update") ||
         below == ".gitignore" || below == ".gitattributes" ||
         (given != setup_.given.end() && size != submission_.sizes.end() && given->second == size->second);
}

std::vector<store::Ignored> StudentRun::worth_telling() const {
  constexpr std::size_t most = 100;
  std::vector<store::Ignored> told = submission_.copies;
  for (const store::Ignored& file : submission_.ignored) {
    const bool is_in_copy = std::ranges::any_of(
        submission_.copies, [&](const store::Ignored& copy) { return file.path.starts_with(copy.path); });
    if (is_in_copy || is_of_system(file.path) || is_of_course(file.path)) continue;
    if (told.size() >= most) {
      told.push_back({"…", fmt::format("and more: {} files in all", submission_.ignored.size())});
      break;
    }
    told.push_back(file);
  }
  return told;
}

JudgedLab StudentRun::judge(const course::Lab& plan, const std::vector<Case>& cases, const Keep& keep) const {
  std::map<std::string, std::string> sources;
  for (const auto& [path, text] : submission_.files)
    if (path.ends_with(".cpp") && path.starts_with(fmt::format("labs/{}/", plan.folder)))
      sources[path] = text;
  const Program program = setup_.workshop->make(plan.program(), sources, &budget_);

  const fs::path out = folder_ / plan.folder;
  fs::remove_all(out);
  check::Drawn drawn;
  if (submission_.fault.empty()) drawn = draw(studio(program, folder_ / "root"), cases, out);

  // Step by step: a mistake shows in all pictures of its step.
  std::vector<StepCases> steps;
  for (const course::Step& step : plan.steps) {
    StepCases& of_step = steps.emplace_back(StepCases{step.id, {}, {}, {}});
    for (const Case& one : cases) {
      if (one.step != step.id) continue;
      const judge::CaseResult& result = of_step.results.emplace_back(judged(plan, one, program, drawn, out));
      if (result.passed()) continue;
      of_step.wrong[one.name] = result.score;
      of_step.failed[one.name] = failed_by(plan, drawn.refused, one, out);
    }
    if (!submission_.fault.empty() || !begun_.contains(step.id) || of_step.failed.empty()) continue;
    if (options_.judge_alone) judge_alone(plan, of_step);
    std::erase_if(of_step.failed,
                  [](const auto& one) { return one.second.picture.empty() && one.second.refused.empty(); });
    if (of_step.failed.empty()) continue;
    const std::map<std::string, judge::Seen> seen = setup_.course->explain(plan, step.id, of_step.failed);
    for (judge::CaseResult& result : of_step.results)
      if (const auto one = seen.find(result.name); one != seen.end())
        result.mistake = one->second.mistake, result.mistake_says = one->second.says;
  }
  if (submission_.fault.empty() && options_.judge_alone) blame(plan, steps);
  for (const StepCases& of_step : steps)
    for (const judge::CaseResult& result : of_step.results) {
      const bool is_wrong = of_step.wrong.contains(result.name) && fs::exists(out / result.file);
      keep(result, is_wrong ? out / result.file : fs::path());
    }
  fs::remove_all(out);
  return {program.refused, drawn.notes};
}

judge::CaseResult StudentRun::judged(const course::Lab& plan, const Case& of, const Program& program,
                                     const check::Drawn& drawn, const fs::path& out) const {
  judge::CaseResult result{of};
  result.command = of.hidden ? "" : course::command(plan, of);
  if (!of.hidden) result.reference = fmt::format("references/{}/{}", plan.folder, of.file);
  const judge::Verdict verdict = check::judge(of, setup_.course->expected(plan, of), out / of.file);
  // A picture that changed through earlier steps does not score for a step that nobody began.
  const bool is_untouched = !begun_.contains(of.step) && (submission_.fault.empty() || submission_.is_empty);
  judge::resolve(result, verdict, fault_of(of, program, drawn), is_untouched);
  return result;
}

std::string StudentRun::fault_of(const Case& of, const Program& program, const check::Drawn& drawn) const {
  const auto place = setup_.course->places().find(of.step);
  if (place != setup_.course->places().end())
    for (const store::CompilerLog& log : program.refused)
      if (log.file == place->second.file)
        return fmt::format("{} does not compile: {}", log.file, first_error(log.text));
  if (!submission_.fault.empty() && !submission_.is_empty) return submission_.fault;
  const auto fault = drawn.faults.find(of.file);
  if (fault == drawn.faults.end()) return {};
  // Without the grader's own folders.
  std::string text = fault->second;
  for (const fs::path& folder : {setup_.models, setup_.starter.source, options_.out / "work", options_.cache})
    for (std::size_t at = 0; (at = text.find(folder.string() + "/", at)) != text.npos;)
      text.erase(at, folder.string().size() + 1);
  return text;
}

}  // namespace texel::grade
