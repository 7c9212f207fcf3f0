// SPDX-License-Identifier: MIT
// One step of a student among the solution's others: so a mistake costs the step in which it was made.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <system_error>

#include "check/check.hpp"
#include "class_run.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "course/markers.hpp"
#include "material/starter.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

/// All files with steps: the solution's, but the student's step in its own; none where that cannot be put
/// together. Those of other labs are the starter's: a step may not borrow their solutions.
std::optional<Files> step_among_solutions(const ClassSetup& setup, Files files, const std::string& step) {
  for (auto& [path, text] : files) {
    const std::string& solution = setup.solution.at(path);
    if (!setup.files_of_step.at(step).contains(path)) {
      text = solution;
    } else
      try {
        text = material::with_step_alone(text, path, step, solution);
      } catch (const Error&) {  // the markers are the student's
        return {};
      }
  }
  return files;
}

}  // namespace

Files StudentRun::own_files(const course::Lab& lab) const {
  Files files;
  for (const auto& [path, solution] : setup_.solution) {
    if (path.find("/" + lab.folder + "/") == std::string::npos) continue;
    const auto own = submission_.files.find(path);
    files[path] = own == submission_.files.end() ? read_file(setup_.starter.source / path) : own->second;
  }
  return files;
}

Files StudentRun::draw_spliced(const Files& spliced, const course::Lab& plan,
                               const std::vector<course::Case>& cases, const fs::path& out) const {
  // Whoever wrote the step as the solution has it gets what the solution drew.
  if (std::ranges::all_of(spliced, [&](const auto& file) {
        return course::is_same_code(file.second, setup_.solution.at(file.first));
      })) {
    fs::create_directories(out / "pictures");
    for (const course::Case& one : cases)
      fs::copy_file(setup_.course->expected(plan, one).reference, out / "pictures" / one.file);
    return {};
  }
  const Program program = setup_.workshop->make(plan.program(), spliced, &budget_);
  // With the starter in place of what was refused, the pictures would be another program's.
  if (!program.refused.empty()) return {};
  make_root(setup_.starter.source, spliced, out / "root");
  return draw(studio(program, out / "root"), cases, out / "pictures").refused;
}

std::optional<Files> StudentRun::draw_alone(const course::Lab& plan, const std::string& step,
                                            const std::vector<course::Case>& cases,
                                            const fs::path& out) const {
  const std::optional<Files> spliced = step_among_solutions(setup_, own_files(plan), step);
  if (!spliced) return {};
  std::string fault;
  try {
    fs::remove_all(out);
    return draw_spliced(*spliced, plan, cases, out);
  } catch (const std::system_error& error) {
    fault = ": " + error.code().message();
  } catch (const std::exception&) {  // it may name files that the program wrote
  }
  throw Error::failed(fmt::format("the machine failed while step {} was judged alone{}", step, fault));
}

void StudentRun::judge_alone(const course::Lab& plan, StepCases& cases) const {
  const fs::path out = folder_ / (plan.folder + ".alone");
  std::vector<course::Case> again;
  for (const judge::CaseResult& result : cases.results)
    if (!result.passed()) again.push_back(result);
  const std::optional<Files> refused = draw_alone(plan, cases.step, again, out);
  for (judge::CaseResult& result : cases.results) {
    if (result.passed()) continue;
    if (!refused) {
      result.judged = judge::Judged::markers_lost;
      continue;
    }
    const judge::Verdict verdict =
        check::judge(result, setup_.course->expected(plan, result), out / "pictures" / result.file);
    const double score = coarse_score(verdict.score);
    judge::Failed& failed = cases.failed[result.name];
    judge::Failed alone = failed_by(plan, *refused, result, out / "pictures");
    alone.is_secret = alone.picture != failed.picture;
    failed = std::move(alone);
    if (verdict.passed) cases.failed.erase(result.name);
    if (score <= result.score) continue;
    result.judged = judge::Judged::alone, result.score = score;
    result.status = verdict.passed ? judge::Status::passed : judge::Status::failed;
    result.error = verdict.passed ? 0 : coarse_error(verdict.error);
  }
  fs::remove_all(out);
}

void StudentRun::blame(const course::Lab& plan, std::vector<StepCases>& steps) const {
  std::vector<course::Case> wrong;
  std::set<std::string> of_steps, begun;
  double sum = 0;
  for (const StepCases& step : steps) {
    if (begun_.contains(step.step)) begun.insert(step.step);
    for (const judge::CaseResult& result : step.results)
      if (begun_.contains(step.step) && !result.passed())
        return;
      else if (result.is_alone())
        wrong.push_back(result), of_steps.insert(result.step), sum += step.wrong.at(result.name);
  }
  if (wrong.empty()) return;
  // What is not begun may be what is wrong with the pictures: it is mended first, and stays so.
  const fs::path out = folder_ / (plan.folder + ".mended");
  const auto heals = [&](const std::string& mended) {
    Files files = own_files(plan);
    for (auto& [path, text] : files)
      for (const auto& [step, solved] : course::step_texts(setup_.solution.at(path)))
        if (step == mended || !begun.contains(step))
          text = course::with_step_from(text, path, step, setup_.solution.at(path));
    fs::remove_all(out);
    static_cast<void>(draw_spliced(files, plan, wrong, out));
    return std::ranges::all_of(wrong, [&](const course::Case& of) {
      return check::judge(of, setup_.course->expected(plan, of), out / "pictures" / of.file).passed;
    });
  };
  std::vector<StepCases*> healers;
  try {
    if (heals("")) return;
    for (StepCases& step : steps)
      if (begun.contains(step.step) && heals(step.step)) healers.push_back(&step);
  } catch (const Error&) {  // markers are damaged
  }
  fs::remove_all(out);
  if (healers.size() != 1) return;
  for (judge::CaseResult& result : healers.front()->results) {
    result.status = judge::Status::failed,
    result.score = coarse_score(sum / static_cast<double>(wrong.size()));
    result.message = fmt::format(
        "This picture is right, but the step spoils pictures of {}: with it mended, and nothing else, they "
        "are right.",
        judge::listed({of_steps.begin(), of_steps.end()}));
  }
}

double coarse_score(double score) {
  return std::floor(100 * score) / 100;
}

double coarse_error(double error) {
  return std::isfinite(error) ? std::strtod(fmt::format("{:.1e}", error).c_str(), nullptr) : error;
}

}  // namespace texel::grade
