// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "core/files.hpp"
#include "core/parallel.hpp"
#include "course/markers.hpp"
#include "grade/course_tree.hpp"
#include "grade/hidden_cases.hpp"
#include "references.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;
using course::Case;

/// A solution of a step: the file in which it differs from the course's.
struct Solution {
  std::string name, step, file, text;
  bool is_right = false;
  const material::Mutant* mutant = nullptr;  ///< of which the grader knows the name, or null
};

/// The solution with each place of a step, one after the other, as the starter has it.
void add_places(const fs::path& course, std::vector<Solution>& all) {
  std::map<std::string, int> count;  // of a step's places, over all files
  for (const std::string& file : course::step_files(course)) {
    const std::string text = read_file(course / file);
    std::map<std::string, int> in_file;
    for (const course::StepPart& part : course::parts_of(text)) {
      int seen = 0;
      const int here = ++in_file[part.step];
      const auto is_solved = [&](const std::string& step) { return step != part.step || ++seen != here; };
      all.push_back({fmt::format("place-{}-of-{}-as-in-the-starter", ++count[part.step], part.step),
                     part.step, file, course::with_steps(text, file, is_solved)});
    }
  }
}

void add_catalogue(const fs::path& course, const std::vector<material::Mutant>& catalogue,
                   std::vector<Solution>& all) {
  for (const material::Mutant& one : catalogue)
    if (!one.step.empty())
      all.push_back({one.name, one.step, one.file, material::mutated(one, read_file(course / one.file)),
                     one.is_right, one.is_right ? nullptr : &one});
}

}  // namespace

std::vector<JudgedSolution> judged_solutions(const CourseTree& tree, int seeds, bool only_places,
                                             const std::function<void(const std::string&)>& say) {
  References course(tree.course, tree.build, tree.cache, "auto");
  std::vector<Solution> all;
  if (!only_places) {
    add_catalogue(tree.course, course.mutants(), all);
    add_catalogue(tree.course, material::read_catalogue(tree.course / "tests/equivalents"), all);
  }
  add_places(tree.course, all);

  std::vector<JudgedSolution> judged;
  for (const course::Lab& lab : tree.labs) {
    std::vector<const Solution*> own;
    for (const Solution& one : all)
      if (std::stoi(one.step) == lab.number) own.push_back(&one);
    std::vector<JudgedSolution> of_lab(own.size());
    std::vector<std::vector<judge::CaseResult>> shown(own.size());
    for (int seed = 0; seed < seeds; ++seed) {
      judge::LabPlan plan = full_plan({lab}, fmt::format("seed {}", seed + 1), tree.cache / "models").front();
      // The public cases are the same for all seeds.
      if (seed > 0) std::erase_if(plan.cases, [](const Case& of) { return !of.hidden; });
      course.prepare(plan);
      in_parallel(processors(), own.size(), [&](std::size_t i) {
        const Solution& of = *own[i];
        const fs::path drawn = course.draw_changed(plan, of.name, of.step, of.file, of.text);
        std::vector<judge::CaseResult> hidden;
        std::map<std::string, judge::Failed> failed;
        for (const Case& one : plan.cases) {
          if (one.step != of.step) continue;
          judge::CaseResult result{one};
          judge::resolve(result, check::judge(one, course.expected(plan, one), drawn / one.file), "", false);
          if (!result.passed() && seed == 0) failed[one.name] = course.drawn_in(drawn, one);
          (one.hidden ? hidden : shown[i]).push_back(std::move(result));
        }
        if (seed == 0 && of.mutant != nullptr && !failed.empty())
          if (const judge::Mistake* known = course.recognize(plan, of.step, failed))
            of_lab[i].called = known->name;
        const auto step = std::ranges::find(lab.steps, of.step, &course::Step::id);
        hidden.insert(hidden.begin(), shown[i].begin(), shown[i].end());
        of_lab[i].by_seed.push_back(judge::step_result(*step, std::move(hidden)));
      });
      say(fmt::format("lab {}, seed {} of {}: {} solutions", lab.number, seed + 1, seeds, own.size()));
    }
    for (std::size_t i = 0; i < own.size(); ++i) {
      of_lab[i].name = own[i]->name, of_lab[i].is_right = own[i]->is_right;
      if (const material::Mutant* mutant = own[i]->mutant)
        of_lab[i].is_called = mutant->same.empty() ? mutant->name : mutant->same;
      judged.push_back(std::move(of_lab[i]));
    }
  }
  return judged;
}

}  // namespace texel::grade
