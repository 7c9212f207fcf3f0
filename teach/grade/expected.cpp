// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "check/check.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "course_side.hpp"
#include "grade/course_tree.hpp"
#include "judge/mistakes.hpp"
#include "judge/plan.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// What the mutants of a lab's steps look like.
std::vector<Mistake> mistakes_of(CourseSide& course, const LabPlan& plan) {
  std::vector<const material::Mutant*> mutants;
  for (const material::Mutant& mutant : course.mutants())
    if (mutant.same.empty() && std::stoi(mutant.step) == plan.lab.number) mutants.push_back(&mutant);
  std::vector<Mistake> all(mutants.size());
  in_parallel(processors(), mutants.size(),
              [&](std::size_t i) { all[i] = course.mistake_of(plan, *mutants[i]); });
  std::erase_if(all, [](const Mistake& mistake) { return mistake.cases.empty(); });
  return all;
}

/// How many of the mistakes are known by their own pictures, and not taken for one before them in the list.
std::size_t told_apart(CourseSide& course, const LabPlan& plan, const std::vector<Mistake>& mistakes) {
  std::size_t count = 0;
  for (const material::Mutant& mutant : course.mutants()) {
    const auto mistake = std::find_if(mistakes.begin(), mistakes.end(),
                                      [&](const Mistake& one) { return one.name == mutant.name; });
    if (mistake == mistakes.end()) continue;
    std::map<std::string, Failed> failed;
    for (const course::Case& one : plan.cases)
      if (mistake->cases.contains(one.name)) failed[one.name] = course.failed_by(plan, mutant, one);
    const Mistake* known = recognise(mistakes, plan, mutant.step, failed);
    if (known != nullptr && known->name == mutant.name) ++count;
  }
  return count;
}

}  // namespace

void write_expected(const CourseTree& options, const std::function<void(const std::string&)>& say) {
  const BuiltTree starter = starter_tree(options.course, options.cache);
  CourseSide course(solution_tree(options.course, options.build, starter), starter, options.cache, "auto");
  for (const LabPlan& plan : public_plan(options.labs)) {
    course.prepare(plan);
    const std::vector<Mistake> mistakes = mistakes_of(course, plan);
    // Beside its place first, so that what is there stays whole.
    const fs::path folder = expected_folder(options.course, plan.lab), fresh = folder.string() + ".part";
    fs::remove_all(fresh);
    fs::create_directories(fresh);
    for (const course::Case& one : plan.cases) {
      const ExpectedFiles expected = course.expected(plan, one);
      fs::copy_file(expected.reference, fresh / one.file);
      if (!expected.mask.empty()) fs::copy_file(expected.mask, fresh / (one.name + ".mask.png"));
    }
    write_file(fresh / kRendererFile, course.renderer() + "\n");
    write_file(fresh / kMistakesFile, to_json(mistakes));
    fs::remove_all(folder);
    fs::rename(fresh, folder);
    say(fmt::format("lab {}: {} pictures, {} mistakes; {} of these differ from all others", plan.lab.number,
                    plan.cases.size(), mistakes.size(), told_apart(course, plan, mistakes)));
  }
}

}  // namespace texel::grade
