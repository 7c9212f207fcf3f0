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
  std::vector<const material::Mutant*> mutants = course.mutants_of(plan.lab);
  std::erase_if(mutants, [](const material::Mutant* mutant) { return !mutant->same.empty(); });
  std::vector<judge::Mistake> all(mutants.size());
  in_parallel(processors(), mutants.size(),
              [&](std::size_t i) { all[i] = course.mistake_of(plan, *mutants[i]); });
  std::erase_if(all, [](const judge::Mistake& mistake) { return mistake.cases.empty(); });
  return all;
}

}  // namespace

void write_expected(const CourseTree& options, const std::function<void(const std::string&)>& say) {
  References course(options.course, options.build, options.cache, "auto");
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
    say(fmt::format("lab {}: {} pictures, {} mistakes", plan.lab.number, plan.cases.size(), mistakes.size()));
  }
}

}  // namespace texel::grade
