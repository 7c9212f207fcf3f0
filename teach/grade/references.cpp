// SPDX-License-Identifier: MIT
#include "references.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>

#include "cache.hpp"
#include "check/check.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "course/batch.hpp"
#include "course/markers.hpp"
#include "grade/hidden_cases.hpp"
#include "grade/submission.hpp"
#include "material/mistake_samples.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;
using course::Case;

/// The instructions that the processor has: the driver compiles its shaders for them.
std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("flags") || line.starts_with("Features")) return line;
  return {};
}

/// The ending of a file that stands in place of a picture: what the program said instead of drawing it.
constexpr const char* kRefused = ".refused";

std::string refused_instead_of(const fs::path& picture) {
  const fs::path file = picture.string() + kRefused;
  return fs::exists(file) ? read_file(file) : "";
}

}  // namespace

std::string renderer_of(const check::Studio& studio) {
  Confines plain;
  plain.environment = check::driver_variables();
  plain.environment.emplace_back("TEXEL_ROOT", studio.root.string());
  plain.environment.emplace_back("MESA_SHADER_CACHE_DISABLE", "true");
  plain.limits.wall_seconds = plain.limits.cpu_seconds = 60;
  const Outcome outcome = run_plainly(
      plain, {studio.program.string(), "--context", studio.context, "--size", "16x16", "--stats", "-"});
  const auto json = json_or_null(outcome.output);
  if (!outcome.succeeded() || !json.is_object())
    throw Error::failed("the course's own program cannot draw", {studio.program.string()}, outcome.errors);
  return json.value("drawn_by", std::string());
}

void draw_all(const check::Studio& studio, const std::vector<Case>& cases, const fs::path& out) {
  const check::Drawn drawn = draw(studio, cases, out);
  if (!drawn.faults.empty()) {
    const auto& [file, fault] = *drawn.faults.begin();
    throw Error::failed(fmt::format("the course's own program does not draw {}: {}", file, fault),
                        {studio.program.string()});
  }
}

References::References(const fs::path& course, const fs::path& build, fs::path cache, std::string context)
    : starter_(starter_tree(course, cache)),
      solution_(solution_tree(course, build, starter_)),
      cache_(std::move(cache)),
      context_(std::move(context)),
      workshop_(solution_, cache_ / "solutions", run_plainly),
      mutants_(material::read_mistakes(solution_.source)),
      places_(course::step_places(starter_.source)) {
  const std::vector<course::Lab> labs = course::read_labs(solution_.source / "labs");
  renderer_ = renderer_of(studio(solution_, labs.front()));
  std::string variables;
  for (const auto& [name, value] : check::driver_variables()) variables += name + "=" + value + "\n";
  surroundings_ = fingerprint({fingerprint_of_folder(solution_.source / "shaders"),
                               fingerprint_of_folder(solution_.source / "assets"), starter_.fingerprint,
                               renderer_, variables, processor(), context_});
}

check::Studio References::studio(const BuiltTree& tree, const course::Lab& plan) const {
  return {tree.build / "bin" / plan.program(), tree.source, context_};
}

void References::prepare(const course::Lab& plan) {
  const fs::path program = solution_.build / "bin" / plan.program();
  const std::string key =
      fingerprint({surroundings_, plan.folder, read_file(program), course::to_batch(plan.cases)});
  const fs::path folder = cache_ / "references" / key.substr(0, 32);
  if (!is_cached(folder)) {
    const fs::path fresh = cache_ / fmt::format("references-{}-{}", ::getpid(), plan.number);
    fs::remove_all(fresh);
    fs::create_directories(fresh);
    draw_all(studio(solution_, plan), plan.cases, fresh / "solution");
    if (const std::vector<Case> masks = masks_of(plan); !masks.empty())
      draw_all(studio(solution_, plan), masks, fresh / "mask");
    draw(studio(starter_, plan), plan.cases, fresh / "starter");
    fs::create_directories(folder.parent_path());
    std::error_code exists;
    fs::rename(fresh, folder, exists);
    fs::remove_all(fresh);
  }
  const std::scoped_lock lock(mutex_);
  folders_[plan.folder] = folder;
}

fs::path References::folder_of(const course::Lab& plan) const {
  return folders_.at(plan.folder);
}

std::vector<const material::Mutant*> References::mutants_of(const course::Lab& lab) const {
  std::vector<const material::Mutant*> own;
  for (const material::Mutant& mutant : mutants_)
    if (std::stoi(mutant.step) == lab.number) own.push_back(&mutant);
  return own;
}

check::ExpectedFiles References::expected(const course::Lab& plan, const Case& of) const {
  const fs::path folder = folder_of(plan);
  return {folder / "solution" / of.file, of.is_mesh() ? fs::path() : folder / "mask" / (of.name + ".png")};
}

fs::path References::draw_changed(const course::Lab& plan, const std::string& name, const std::string& step,
                                  const std::string& file, const std::string& text) {
  std::unique_lock all(mutex_);
  std::mutex& own = drawing_[name + "/" + plan.folder];
  all.unlock();
  const std::scoped_lock lock(own);
  const fs::path folder =
      folder_of(plan) / "mutants" / fingerprint({name, file, text, kRefused}).substr(0, 32);
  if (fs::exists(folder)) return folder;
  const fs::path fresh = cache_ / fmt::format("mutant-{}-{}-{}", ::getpid(), plan.number, name);
  fs::remove_all(fresh);
  fs::create_directories(fresh);
  check::Studio studio = this->studio(solution_, plan);
  if (file.starts_with("shaders/")) {
    studio.root = fresh / "root";
    make_root(solution_.source, {{file, text}}, studio.root);
  } else {
    const Program made = workshop_.make(plan.program(), {{file, text}});
    for (const store::CompilerLog& log : made.refused)
      throw Error::failed(fmt::format("'{}' does not compile", name), {log.file}, log.text);
    studio.program = made.file;
  }
  // Only the cases of its step: nobody asks for the others.
  std::vector<Case> cases = plan.cases;
  std::erase_if(cases, [&](const Case& one) { return one.step != step; });
  const check::Drawn drawn = draw(studio, cases, fresh / "out");
  fs::create_directories(fresh / "out");
  for (const auto& [picture, refused] : drawn.refused)
    write_file(fresh / "out" / (picture + kRefused), refused);
  fs::create_directories(folder.parent_path());
  std::error_code exists;
  fs::rename(fresh / "out", folder, exists);
  fs::remove_all(fresh);
  return folder;
}

judge::Failed References::drawn_in(const course::Lab& plan, const fs::path& folder, const Case& of) const {
  const check::ExpectedFiles files = expected(plan, of);
  return {check::picture_bytes(folder / of.file), refused_instead_of(folder / of.file),
          read_file(files.reference), files.mask.empty() ? "" : read_file(files.mask)};
}

fs::path References::drawn_by(const course::Lab& plan, const material::Mutant& mutant) {
  return draw_changed(plan, mutant.name, mutant.step, mutant.file,
                      material::mutated(mutant, read_file(solution_.source / mutant.file)));
}

judge::Mistake References::mistake_of(const course::Lab& plan, const material::Mutant& mutant) {
  judge::Mistake mistake{mutant.name, mutant.step, mutant.says, {}};
  const fs::path drawn = drawn_by(plan, mutant);
  for (const Case& of : plan.cases) {
    if (of.step != mutant.step || check::judge(of, expected(plan, of), drawn / of.file).passed) continue;
    judge::Samples samples =
        material::sampled(of, read_file(expected(plan, of).reference), check::picture_bytes(drawn / of.file));
    samples.refused = refused_instead_of(drawn / of.file);
    if (!samples.samples.empty() || !samples.refused.empty()) mistake.cases[of.name] = std::move(samples);
  }
  return mistake;
}

const std::vector<judge::Mistake>& References::known_mistakes(const course::Lab& plan) {
  const std::scoped_lock lock(mutex_);
  const auto found = known_mistakes_.find(plan.folder);
  if (found != known_mistakes_.end()) return found->second;
  return known_mistakes_[plan.folder] = check::known_mistakes(check::expected_folder(solution_.source, plan));
}

const std::vector<judge::Mistake>& References::unseen_mistakes(const course::Lab& plan,
                                                               const std::string& step) {
  {
    const std::scoped_lock lock(mutex_);
    if (const auto found = unseen_mistakes_.find(step); found != unseen_mistakes_.end()) return found->second;
  }
  const std::vector<judge::Mistake>& known = known_mistakes(plan);
  std::vector<judge::Mistake> unseen;
  for (const material::Mutant& mutant : mutants_)
    if (mutant.step == step && mutant.same.empty() &&
        std::ranges::find(known, mutant.name, &judge::Mistake::name) == known.end())
      unseen.push_back(mistake_of(plan, mutant));
  const std::scoped_lock lock(mutex_);
  return unseen_mistakes_.emplace(step, std::move(unseen)).first->second;  // of the thread that was first
}

std::map<std::string, judge::Seen> References::explain(const course::Lab& plan, const std::string& step,
                                                       const std::map<std::string, judge::Failed>& failed) {
  std::map<std::string, judge::Failed> seen = failed;  // by the student, as by `check`
  for (const Case& one : plan.cases)
    if (one.hidden) seen.erase(one.name);
  return seen.empty() ? judge::explain(unseen_mistakes(plan, step), plan, step, failed)
                      : judge::explain(known_mistakes(plan), plan, step, seen);
}

}  // namespace texel::grade
