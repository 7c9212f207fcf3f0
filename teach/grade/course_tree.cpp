// SPDX-License-Identifier: MIT
#include "grade/course_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "check/check.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "course/markers.hpp"
#include "grade/hidden_cases.hpp"
#include "judge/mistakes.hpp"
#include "material/mistake_samples.hpp"
#include "material/starter.hpp"
#include "references.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;
using course::Case;

/// What the mutants of a lab's steps look like.
std::vector<judge::Mistake> mistakes_of(References& course, const course::Lab& plan) {
  std::vector<const material::Mutant*> mutants = course.mutants_of(plan);
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
  for (const course::Lab& lab : options.labs) {
    const course::Lab plan = course::with_public_cases(lab);
    course.prepare(plan);
    const std::vector<judge::Mistake> mistakes = mistakes_of(course, plan);
    // Beside its place first, so that what is there stays whole.
    const fs::path folder = check::expected_folder(options.course, plan), fresh = folder.string() + ".part";
    fs::remove_all(fresh);
    fs::create_directories(fresh);
    for (const course::Case& one : plan.cases) {
      const check::ExpectedFiles expected = course.expected(plan, one);
      fs::copy_file(expected.reference, fresh / one.file);
      if (!expected.mask.empty()) fs::copy_file(expected.mask, fresh / (one.name + ".mask.png"));
    }
    write_file(fresh / check::kRendererFile, course.renderer() + "\n");
    write_file(fresh / check::kMistakesFile, material::to_json(mistakes));
    fs::remove_all(folder);
    fs::rename(fresh, folder);
    say(fmt::format("lab {}: {} pictures, {} mistakes", plan.number, plan.cases.size(), mistakes.size()));
  }
}

// --- What right and wrong solutions of each step get -------------------------------------------------------

namespace {

/// A solution of a step: the file in which it differs from the course's.
struct Solution {
  std::string name, step, file, text;
  bool is_right = false;
  std::string is_called = {};  ///< what the grader is to take it for, or ""
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
  for (const material::Mutant& one : catalogue) {
    if (one.step.empty()) continue;
    const std::string mistake = one.same.empty() ? one.name : one.same;
    all.push_back({one.name, one.step, one.file, material::mutated(one, read_file(course / one.file)),
                   one.is_right, one.is_right ? "" : mistake});
  }
}

Json to_json(const judge::StepResult& step) {
  Json cases = Json::array();
  for (const judge::CaseResult& one : step.cases)
    cases.push_back({{"case", one.name},
                     {"passed", one.passed()},
                     {"error", one.error},  // NaN becomes null
                     {"limit", one.limit},
                     {"unit", name_of(one.unit())}});
  return {{"passed", step.status == judge::Status::passed}, {"score", step.score}, {"cases", cases}};
}

}  // namespace

Json judged_solutions(const CourseTree& tree, int seeds, const fs::path& catalogue, bool only_places,
                      const std::function<void(const std::string&)>& say) {
  References course(tree.course, tree.build, tree.cache, "auto");
  std::vector<Solution> all;
  if (!catalogue.empty()) {
    add_catalogue(tree.course, material::read_catalogue(catalogue), all);
    for (Solution& one : all) one.is_called.clear();
  } else if (!only_places) {
    add_catalogue(tree.course, course.mutants(), all);
    add_catalogue(tree.course, material::read_catalogue(tree.course / "tests/equivalents"), all);
  }
  if (catalogue.empty()) add_places(tree.course, all);

  Json judged = Json::array();
  for (const course::Lab& lab : tree.labs) {
    std::vector<const Solution*> own;
    for (const Solution& one : all)
      if (std::stoi(one.step) == lab.number) own.push_back(&one);
    std::vector<Json> of_lab;
    for (const Solution* one : own)
      of_lab.push_back({{"step", one->step},
                        {"name", one->name},
                        {"is_right", one->is_right},
                        {"called", ""},
                        {"is_called", one->is_called},
                        {"says", Json::object()},
                        {"seeds", Json::array()}});
    std::vector<std::vector<judge::CaseResult>> shown(own.size());
    for (int seed = 0; seed < seeds; ++seed) {
      course::Lab plan = full_plan({lab}, fmt::format("seed {}", seed + 1), tree.cache / "models").front();
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
          if (!result.passed() && seed == 0) failed[one.name] = course.drawn_in(plan, drawn, one);
          (one.hidden ? hidden : shown[i]).push_back(std::move(result));
        }
        if (seed == 0 && !of.is_right && !failed.empty())
          for (const auto& [name, seen] : course.explain(plan, of.step, failed)) {
            of_lab[i]["says"][name] = seen.says;
            if (of_lab[i]["called"] == "" && (!of.is_called.empty() || !catalogue.empty()))
              of_lab[i]["called"] = seen.mistake;
          }
        const auto step = std::ranges::find(lab.steps, of.step, &course::Step::id);
        hidden.insert(hidden.begin(), shown[i].begin(), shown[i].end());
        of_lab[i]["seeds"].push_back(to_json(judge::step_result(*step, std::move(hidden))));
      });
      say(fmt::format("lab {}, seed {} of {}: {} solutions", lab.number, seed + 1, seeds, own.size()));
    }
    for (Json& one : of_lab) judged.push_back(std::move(one));
  }
  return judged;
}

// --- How far renderers are from each other -----------------------------------------------------------------

namespace {

/// Those of the hidden cases: any will do.
constexpr std::array kSeeds = {"one", "two", "three"};

check::Studio studio(const CourseTree& tree, const course::Lab& lab, const std::string& context) {
  return {tree.build / "bin" / lab.program(), tree.course, context};
}

/// The cases of a seed; of others than the first the hidden ones alone, as the public ones are the same.
std::vector<course::Lab> plans_of(const CourseTree& tree, const std::string& seed, const fs::path& models) {
  std::vector<course::Lab> plans = full_plan(tree.labs, seed, models);
  if (seed != kSeeds.front())
    for (course::Lab& one : plans)
      std::erase_if(one.cases, [](const course::Case& of) { return !of.hidden; });
  return plans;
}

/// What check compares a public case with.
check::ExpectedFiles expected_files(const CourseTree& tree, const course::Lab& lab, const course::Case& of) {
  const fs::path folder = check::expected_folder(tree.course, lab);
  return {folder / of.file, of.is_mesh() ? fs::path() : folder / (of.name + ".mask.png")};
}

}  // namespace

std::string renderer_here(const CourseTree& tree, const std::string& context) {
  return renderer_of(studio(tree, tree.labs.front(), context));
}

void draw_cases(const CourseTree& tree, const std::string& context, const fs::path& out) {
  for (const char* seed : kSeeds) {
    const std::vector<course::Lab> plans = plans_of(tree, seed, out.parent_path() / "models");
    in_parallel(processors(), plans.size(), [&](std::size_t i) {
      const check::Studio own = studio(tree, plans[i], context);
      const fs::path to = out / seed / plans[i].folder;
      fs::create_directories(to);
      if (plans[i].cases.empty()) return;
      draw_all(own, plans[i].cases, to);
      draw_all(own, masks_of(plans[i]), to / "mask");
    });
  }
}

std::vector<std::string> wrongly_passed(const CourseTree& tree, const std::string& context,
                                        const std::function<void(const std::string&)>& say) {
  std::vector<std::string> faults;
  References course(tree.course, tree.build, tree.cache, context);
  // By what this renderer draws, as grade has it, or by what is kept, as check has it: one of them is enough.
  const auto is_passed = [&](const course::Lab& lab, const std::string& step, const fs::path& folder) {
    return std::all_of(lab.cases.begin(), lab.cases.end(), [&](const course::Case& of) {
      const fs::path picture = folder / of.file;
      return of.step != step || check::judge(of, course.expected(lab, of), picture).passed ||
             (!of.hidden && check::judge(of, expected_files(tree, lab, of), picture).passed);
    });
  };
  for (const course::Lab& lab : full_plan(tree.labs, kSeeds.front(), tree.cache / "models")) {
    course.prepare(lab);
    for (const course::Step& step : lab.steps)
      if (is_passed(lab, step.id, course.starter_folder(lab)))
        faults.push_back(fmt::format("the starter passes step {}", step.id));
    const std::vector<const material::Mutant*> mutants = course.mutants_of(lab);
    std::vector<char> passed(mutants.size());
    in_parallel(processors(), mutants.size(), [&](std::size_t i) {
      passed[i] = is_passed(lab, mutants[i]->step, course.drawn_by(lab, *mutants[i]));
    });
    for (std::size_t i = 0; i < mutants.size(); ++i)
      if (passed[i] != 0)
        faults.push_back(fmt::format("mutant {} passes step {}", mutants[i]->name, mutants[i]->step));
    say(fmt::format("lab {}, {} mutants", lab.number, mutants.size()));
  }
  return faults;
}

Json spreads(const CourseTree& tree, const fs::path& drawn, const std::string& reference) {
  std::vector<std::string> renderers;
  for (const fs::directory_entry& entry : fs::directory_iterator(drawn))
    if (fs::exists(entry.path() / check::kRendererFile))
      renderers.push_back(entry.path().filename().string());
  std::map<std::pair<int, std::string>, std::map<std::string, double>>
      errors;  // by lab and case, by renderer
  for (const course::Lab& lab : tree.labs)
    for (const course::Case& one : lab.cases) errors[{lab.number, one.name}];
  for (const char* seed : kSeeds)
    for (const course::Lab& lab : plans_of(tree, seed, drawn / "models"))
      in_parallel(processors(), lab.cases.size(), [&](std::size_t i) {
        const course::Case& of = lab.cases[i];
        const fs::path folder = fs::path(seed) / lab.folder;
        check::ExpectedFiles expected = expected_files(tree, lab, of);
        if (of.hidden) {
          expected.reference = drawn / reference / folder / of.file;
          if (!of.is_mesh()) expected.mask = drawn / reference / folder / "mask" / (of.name + ".png");
        }
        for (const std::string& renderer : renderers) {
          const double error = check::judge(of, expected, drawn / renderer / folder / of.file).error;
          double& most = errors.at({lab.number, of.name})[renderer];
          most = std::isnan(error) || std::isnan(most) ? std::nan("") : std::max(most, error);
        }
      });
  const std::map<std::string, Place> places = material::first_places(tree.course);
  Json all = Json::array();
  for (const course::Lab& lab : tree.labs)
    for (const course::Case& one : lab.cases)
      all.push_back({{"lab", lab.number},
                     {"case", one.name},
                     {"unit", name_of(unit_of(one.view))},
                     {"in_pages", !one.hidden && places.at(one.step).file.starts_with("shaders/")},
                     {"by", errors.at({lab.number, one.name})}});  // NaN becomes null
  return all;
}

}  // namespace texel::grade
