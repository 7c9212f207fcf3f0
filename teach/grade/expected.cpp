// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "check/check.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "grade/course_tree.hpp"
#include "judge/mistakes.hpp"
#include "judge/plan.hpp"
#include "references.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// What the mutants of a lab's steps look like.
std::vector<judge::Mistake> mistakes_of(References& course, const judge::LabPlan& plan) {
  std::vector<const material::Mutant*> mutants;
  for (const material::Mutant& mutant : course.mutants())
    if (mutant.same.empty() && std::stoi(mutant.step) == plan.lab.number) mutants.push_back(&mutant);
  std::vector<judge::Mistake> all(mutants.size());
  in_parallel(processors(), mutants.size(),
              [&](std::size_t i) { all[i] = course.mistake_of(plan, *mutants[i]); });
  std::erase_if(all, [](const judge::Mistake& mistake) { return mistake.cases.empty(); });
  return all;
}

/// How many of the mistakes are known by their own pictures, and not taken for one before them in the list.
std::size_t told_apart(References& course, const judge::LabPlan& plan,
                       const std::vector<judge::Mistake>& mistakes) {
  std::size_t count = 0;
  for (const material::Mutant& mutant : course.mutants()) {
    const auto mistake = std::find_if(mistakes.begin(), mistakes.end(),
                                      [&](const judge::Mistake& one) { return one.name == mutant.name; });
    if (mistake == mistakes.end()) continue;
    std::map<std::string, judge::Failed> failed;
    for (const course::Case& one : plan.cases)
      if (mistake->cases.contains(one.name)) failed[one.name] = course.failed_by(plan, mutant, one);
    const judge::Mistake* known = judge::recognize(mistakes, plan, mutant.step, failed);
    if (known != nullptr && known->name == mutant.name) ++count;
  }
  return count;
}

}  // namespace

void write_expected(const CourseTree& options, const std::function<void(const std::string&)>& say) {
  const BuiltTree starter = starter_tree(options.course, options.cache);
  References course(solution_tree(options.course, options.build, starter), starter, options.cache, "auto");
  for (const judge::LabPlan& plan : judge::public_plan(options.labs)) {
    course.prepare(plan);
    const std::vector<judge::Mistake> mistakes = mistakes_of(course, plan);
    // Beside its place first, so that what is there stays whole.
    const fs::path folder = check::expected_folder(options.course, plan.lab),
                   fresh = folder.string() + ".part";
    fs::remove_all(fresh);
    fs::create_directories(fresh);
    for (const course::Case& one : plan.cases) {
      const check::ExpectedFiles expected = course.expected(plan, one);
      fs::copy_file(expected.reference, fresh / one.file);
      if (!expected.mask.empty()) fs::copy_file(expected.mask, fresh / (one.name + ".mask.png"));
    }
    write_file(fresh / check::kRendererFile, course.renderer() + "\n");
    write_file(fresh / check::kMistakesFile, to_json(mistakes));
    fs::remove_all(folder);
    fs::rename(fresh, folder);
    say(fmt::format("lab {}: {} pictures, {} mistakes; {} of these differ from all others", plan.lab.number,
                    plan.cases.size(), mistakes.size(), told_apart(course, plan, mistakes)));
  }
}

}  // namespace texel::grade
