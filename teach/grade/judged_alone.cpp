// SPDX-License-Identifier: MIT
#include "judged_alone.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <system_error>

#include "check/studio.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "course/markers.hpp"
#include "course/same_code.hpp"
#include "grade/submission.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

constexpr std::string_view kShaders = "shaders/";

/// Whether a file is another lab's alone.
bool is_of_another_lab(const std::string& path, const course::Lab& lab) {
  return path.find("/" + lab.folder + "/") == path.npos;
}

/// All files with steps: the solution's, but the student's step in its own; none where that cannot be put
/// together. Those of other labs are the starter's: a step may not borrow their solutions.
std::optional<Files> step_among_solutions(const ClassSetup& setup, const Files& files, const course::Lab& lab,
                                          const std::string& step) {
  Files spliced = setup.solution;
  std::erase_if(spliced, [&](const auto& file) { return is_of_another_lab(file.first, lab); });
  for (auto& [path, text] : spliced) {
    if (!setup.files_of_step.at(step).contains(path)) continue;
    const auto own = files.find(path);
    try {
      text = course::with_step_alone(
          own == files.end() ? read_file(setup.starter.source / path) : own->second, path, step, text);
    } catch (const Error&) {  // the markers are the student's
      return {};
    }
  }
  return spliced;
}

/// Whether the student wrote the step as the solution has it.
bool is_solution(const ClassSetup& setup, const Files& spliced) {
  return std::all_of(spliced.begin(), spliced.end(), [&](const auto& file) {
    return course::is_same_code(file.second, setup.solution.at(file.first));
  });
}

/// What the solution drew for the same cases.
Files copy_expected(const ClassSetup& setup, const judge::LabPlan& plan,
                    const std::vector<course::Case>& cases, const fs::path& out) {
  fs::create_directories(out);
  for (const course::Case& one : cases)
    fs::copy_file(setup.course->expected(plan, one).reference, out / one.file);
  return {};
}

check::Drawn draw_spliced(const ClassSetup& setup, const GradeOptions& options, const Files& spliced,
                          const judge::LabPlan& plan, const std::vector<course::Case>& cases,
                          const fs::path& work, const fs::path& out, TimeBudget* budget) {
  Files sources, shaders;
  for (const auto& [path, text] : spliced) {
    if (path.ends_with(".cpp")) sources[path] = text;
    if (path.starts_with(kShaders)) shaders[path.substr(kShaders.size())] = text;
  }
  const Program program = setup.workshop->make(plan.lab.program(), sources, budget);
  // With the starter in place of what was refused, the pictures would be another program's.
  if (!program.refused.empty()) return {};
  overlay(setup.starter.source / "shaders", shaders, work / "shaders");
  fs::create_directory_symlink(setup.starter.source / "assets", work / "assets");
  check::Studio studio{program.file, work, options.context, options.run, {setup.starter.source / "assets"}};
  studio.budget = budget;
  if (fs::exists(setup.models)) studio.readable.push_back(setup.models);
  return draw(studio, cases, out);
}

}  // namespace

std::optional<Files> draw_alone(const ClassSetup& setup, const GradeOptions& options, const Files& files,
                                const judge::LabPlan& plan, const std::string& step,
                                const std::vector<course::Case>& cases, const fs::path& work,
                                const fs::path& out, TimeBudget* budget) {
  const std::optional<Files> spliced = step_among_solutions(setup, files, plan.lab, step);
  if (!spliced) return {};
  std::string fault;
  try {
    fs::remove_all(work);
    fs::remove_all(out);
    if (is_solution(setup, *spliced)) return copy_expected(setup, plan, cases, out);
    return draw_spliced(setup, options, *spliced, plan, cases, work, out, budget).refused;
  } catch (const std::system_error& error) {
    fault = ": " + error.code().message();
  } catch (const std::exception&) {  // it may name files that the program wrote
  }
  throw Error::failed(fmt::format("the machine failed while step {} was judged alone{}", step, fault));
}

double coarse_score(double score) {
  return std::floor(100 * score) / 100;
}

double coarse_error(double error) {
  return std::isfinite(error) ? std::strtod(fmt::format("{:.1e}", error).c_str(), nullptr) : error;
}

}  // namespace texel::grade
