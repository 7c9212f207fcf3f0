// SPDX-License-Identifier: MIT
#include "grade/marks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/files.hpp"
#include "core/parallel.hpp"
#include "course/markers.hpp"
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

/// What a solution got with all seeds: its step's cases, the public ones first.
struct BySeed {
  std::vector<judge::CaseResult> shown;
  std::vector<std::vector<judge::CaseResult>> hidden;  ///< by seed
  std::string called;                                  ///< by the first seed
};

/// The solution with each place of a step, one after the other, as the starter has it.
void add_places(const fs::path& course, std::vector<Solution>& all) {
  std::map<std::string, int> count;  // of a step's places, over all files
  for (const std::string& file : course::step_files(course)) {
    const std::string text = read_file(course / file);
    std::map<std::string, int> in_file;
    for (const course::Marker& marker : course::markers_of(text, file)) {
      if (marker.step.empty()) continue;
      int seen = 0;
      const int here = ++in_file[marker.step];
      const auto is_solved = [&](const std::string& step) { return step != marker.step || ++seen != here; };
      all.push_back({fmt::format("place-{}-of-{}-as-in-the-starter", ++count[marker.step], marker.step),
                     marker.step, file, course::with_steps(text, file, is_solved)});
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

/// Infinite where nothing can be compared, or single pixels are not finite.
double times_limit(const judge::CaseResult& one) {
  const double times = one.error / one.limit;
  return one.passed() || times > 1 ? times : std::numeric_limits<double>::infinity();
}

/// The case that is furthest off.
Far furthest(const std::string& by, const std::vector<judge::CaseResult>& cases) {
  Far far{by, -1, 0, 0, "", "", 1};
  for (const judge::CaseResult& one : cases)
    if (const double times = times_limit(one); times > far.times_limit)
      far = {by, times, one.error, one.limit, name_of(one.unit()), one.name, 1};
  return far;
}

/// Judges the step with each seed. The worse or the better one for the course is kept.
Far judged_by_seeds(const course::Step& step, const Solution& of, const BySeed& judged,
                    std::vector<std::string>& faults) {
  Far kept;
  for (std::size_t seed = 0; seed < judged.hidden.size(); ++seed) {
    std::vector<judge::CaseResult> cases = judged.shown;
    cases.insert(cases.end(), judged.hidden[seed].begin(), judged.hidden[seed].end());
    Far far = furthest(of.name, cases);
    const judge::StepResult result = judge::step_result(step, std::move(cases));
    far.mark = result.score;
    if ((result.status == judge::Status::passed) != of.is_right)
      faults.push_back(fmt::format("{}: '{}' {} with seed {}: {} {} off in {}, {:.3g} times the limit",
                                   step.id, of.name, of.is_right ? "fails" : "passes", seed + 1, far.error,
                                   far.unit, far.at, far.times_limit));
    if (seed == 0 || (far.times_limit > kept.times_limit) == of.is_right) {
      far.mark = seed == 0     ? far.mark
                 : of.is_right ? std::min(far.mark, kept.mark)
                               : std::max(far.mark, kept.mark);
      kept = far;
    }
  }
  return kept;
}

}  // namespace

double StepMarks::apart() const {
  const double furthest = rights.empty() ? 0 : rights.front().times_limit;
  const double smallest = mistakes.empty() ? 0 : mistakes.front().times_limit;
  return furthest > 0 ? smallest / furthest : std::numeric_limits<double>::infinity();
}

std::vector<StepMarks> marks_of(const CourseTree& tree, int seeds, bool only_places, const Spreads& spreads,
                                std::vector<std::string>& faults,
                                const std::function<void(const std::string&)>& say) {
  const BuiltTree starter = starter_tree(tree.course, tree.cache);
  References course(solution_tree(tree.course, tree.build, starter), starter, tree.cache, "auto");
  std::vector<Solution> all;
  if (!only_places) add_catalogue(tree.course, course.mutants(), all);
  if (!only_places)
    add_catalogue(tree.course, material::read_catalogue(tree.course / "tests/equivalents"), all);
  add_places(tree.course, all);

  std::vector<StepMarks> marks;
  for (const course::Lab& lab : tree.labs) {
    std::vector<const Solution*> own;
    for (const Solution& one : all)
      if (std::stoi(one.step) == lab.number) own.push_back(&one);
    std::vector<BySeed> judged(own.size());
    for (int seed = 0; seed < seeds; ++seed) {
      judge::LabPlan plan = full_plan({lab}, fmt::format("seed {}", seed + 1), tree.cache / "models").front();
      // The public cases are the same for all seeds.
      if (seed > 0) std::erase_if(plan.cases, [](const Case& of) { return !of.hidden; });
      course.prepare(plan);
      in_parallel(processors(), own.size(), [&](std::size_t i) {
        const Solution& of = *own[i];
        const fs::path drawn = course.draw_changed(plan, of.name, of.step, of.file, of.text);
        judged[i].hidden.emplace_back();
        std::map<std::string, judge::Failed> failed;
        for (const Case& one : plan.cases) {
          if (one.step != of.step) continue;
          judge::CaseResult result{one};
          judge::resolve(result, check::judge(one, course.expected(plan, one), drawn / one.file), "", false);
          if (!result.passed() && seed == 0) failed[one.name] = course.drawn_in(drawn, one);
          (one.hidden ? judged[i].hidden.back() : judged[i].shown).push_back(std::move(result));
        }
        if (seed == 0 && of.mutant != nullptr && !failed.empty())
          if (const judge::Mistake* known = course.recognize(plan, of.step, failed))
            judged[i].called = known->name;
      });
      say(fmt::format("lab {}, seed {} of {}: {} solutions", lab.number, seed + 1, seeds, own.size()));
    }
    for (const course::Step& step : lab.steps) {
      StepMarks of{step.id, {}, {}};
      for (std::size_t i = 0; i < own.size(); ++i)
        if (own[i]->step == step.id) {
          const material::Mutant* mutant = own[i]->mutant;
          if (mutant != nullptr && judged[i].called != (mutant->same.empty() ? mutant->name : mutant->same))
            faults.push_back(fmt::format("{}: '{}' is called '{}'", step.id, mutant->name, judged[i].called));
          (own[i]->is_right ? of.rights : of.mistakes)
              .push_back(judged_by_seeds(step, *own[i], judged[i], faults));
        }
      for (const course::GradedCase& one : lab.cases)
        if (const auto found = spreads.find({lab.number, one.name});
            found != spreads.end() && one.step == step.id)
          of.rights.push_back({"renderers", found->second / one.limit, found->second, one.limit,
                               name_of(unit_of(one.view)), one.name, 1});
      const auto smaller = [](const Far& a, const Far& b) { return a.times_limit < b.times_limit; };
      std::stable_sort(of.mistakes.begin(), of.mistakes.end(), smaller);
      std::stable_sort(of.rights.rbegin(), of.rights.rend(), smaller);
      marks.push_back(std::move(of));
    }
  }
  return marks;
}

}  // namespace texel::grade
