// SPDX-License-Identifier: MIT
#include "student_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "check/files.hpp"
#include "core/files.hpp"
#include "course/markers.hpp"
#include "fingerprint.hpp"

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

/// The steps between whose markers a submission has what the starter has.
std::set<std::string> untouched(const Preparation& preparation,
                                const std::map<std::string, std::string>& files) {
  std::set<std::string> steps;
  for (const std::string& path : preparation.allowed) {
    const std::string first = read_file(preparation.starter.source / path);
    const auto file = files.find(path);
    steps.merge(course::untouched_steps(file == files.end() ? first : file->second, first, path));
  }
  return steps;
}

}  // namespace

StudentRun::StudentRun(const Preparation& preparation, const GradeOptions& options, const Entry& entry,
                       fs::path folder)
    : preparation_(preparation),
      options_(options),
      folder_(std::move(folder)),
      submission_(unpack(entry, preparation.allowed)),
      untouched_(untouched(preparation, submission_.files)) {
  std::map<std::string, std::string> shaders;
  for (const auto& [path, text] : submission_.files) {
    digest_ = fingerprint({digest_, path, text});
    if (path.starts_with("shaders/")) shaders[path.substr(8)] = text;
  }
  digest_ = fingerprint({digest_, submission_.fault});
  fs::remove_all(folder_);
  overlay(preparation.starter.source / "shaders", shaders, folder_ / "root/shaders");
  fs::create_directory_symlink(preparation.starter.source / "assets", folder_ / "root/assets");
}

StudentRun::~StudentRun() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

/// Nothing is wrong with the file, and the starter has one of that name.
bool StudentRun::is_of_course(const std::string& path) const {
  std::error_code too_long;
  return submission_.sound.contains(path) && path.starts_with(submission_.root) &&
         fs::exists(preparation_.starter.source / path.substr(submission_.root.size()), too_long);
}

std::vector<Ignored> StudentRun::worth_telling() const {
  constexpr std::size_t most = 100;
  std::vector<Ignored> told;
  for (const Ignored& file : submission_.ignored) {
    if (is_of_course(file.path)) continue;
    if (told.size() == most) {
      told.push_back({"…", fmt::format("and more: {} files in all", submission_.ignored.size())});
      break;
    }
    told.push_back(file);
  }
  return told;
}

JudgedLab StudentRun::judge(const LabPlan& plan, const std::vector<Case>& cases,
                            const std::function<void(const JudgedCase&)>& keep) const {
  std::map<std::string, std::string> sources;
  for (const auto& [path, text] : submission_.files)
    if (path.ends_with(".cpp")) sources[path] = text;
  const Program program = preparation_.workshop->make(plan.lab.program(), sources, &budget_);

  const fs::path out = folder_ / plan.lab.folder;
  Studio studio{program.file,
                folder_ / "root",
                options_.context,
                options_.run,
                {preparation_.starter.source / "assets"}};
  studio.budget = &budget_;
  if (fs::exists(preparation_.models)) studio.readable.push_back(preparation_.models);
  fs::remove_all(out);
  const Drawn drawn = submission_.fault.empty() ? draw(studio, cases, out) : Drawn();

  // Step by step: a mistake shows in all pictures of its step.
  for (const course::Step& step : plan.lab.steps) {
    std::vector<CaseResult> results;
    std::map<std::string, Failed> failed;
    for (const Case& one : cases) {
      if (one.step != step.id) continue;
      results.push_back(judged(plan, one, program, drawn, out));
      if (results.back().passed()) continue;
      const auto refused = drawn.refused.find(one.file);
      const Failed wrong{picture_bytes(out / one.file),
                         refused == drawn.refused.end() ? "" : refused->second};
      if (!wrong.picture.empty() || !wrong.refused.empty()) failed[one.name] = wrong;
    }
    const Mistake* mistake = failed.empty() || untouched_.contains(step.id)
                                 ? nullptr
                                 : preparation_.course->recognise(plan, step.id, failed);
    for (CaseResult& result : results) {
      const auto wrong = failed.find(result.name);
      if (wrong != failed.end() && mistake != nullptr)
        result.mistake = mistake->name, result.mistake_says = mistake->says;
      const bool has_picture = wrong != failed.end() && !wrong->second.picture.empty();
      keep({result, has_picture ? out / result.file : fs::path()});
    }
  }
  fs::remove_all(out);
  return {program.refused, drawn.notes};
}

CaseResult StudentRun::judged(const LabPlan& plan, const Case& of, const Program& program, const Drawn& drawn,
                              const fs::path& out) const {
  CaseResult result{of};
  result.command = of.hidden ? "" : command(plan.lab, of);
  if (!of.hidden) result.reference = fmt::format("references/{}/{}", plan.lab.folder, of.file);
  CourseSide& course = *preparation_.course;
  const Verdict verdict = grade::judge(of, course.expected(plan, of), out / of.file);
  // A picture that changed through earlier steps does not score for a step that nobody began.
  const bool is_untouched = untouched_.contains(of.step) && submission_.fault.empty();
  settle(result, verdict, fault_of(of, program, drawn), is_untouched);
  // Finding what scores 0 needs more pictures. They are drawn only if the case may score.
  const bool may_earn = !verdict.passed && std::isfinite(verdict.wrongness) && !untouched_.contains(of.step);
  result.score = score(of, verdict, may_earn ? course.worthless(plan, of) : 0);
  return result;
}

std::string StudentRun::fault_of(const Case& of, const Program& program, const Drawn& drawn) const {
  const auto place = preparation_.course->places().find(of.step);
  if (place != preparation_.course->places().end())
    for (const CompilerLog& log : program.refused)
      if (log.file == place->second.file)
        return fmt::format("{} does not compile: {}", log.file, first_error(log.text));
  if (!submission_.fault.empty()) return submission_.fault;
  const auto fault = drawn.faults.find(of.file);
  if (fault == drawn.faults.end()) return {};
  // Without the grader's own folders.
  std::string text = fault->second;
  for (const fs::path& folder : {preparation_.models, preparation_.starter.source, options_.out / "work"})
    for (std::size_t at = 0; (at = text.find(folder.string() + "/", at)) != text.npos;)
      text.erase(at, folder.string().size() + 1);
  return text;
}

}  // namespace texel::grade
