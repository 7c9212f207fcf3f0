// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "check/check.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "course/markers.hpp"
#include "grade/course_tree.hpp"
#include "grade/hidden_cases.hpp"
#include "references.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// Those of the hidden cases: any will do.
constexpr std::array kSeeds = {"one", "two", "three"};

check::Studio studio(const CourseTree& tree, const course::Lab& lab, const std::string& context) {
  return {tree.build / "bin" / lab.program(), tree.course, context};
}

/// The cases of a seed; of others than the first the hidden ones alone, as the public ones are the same.
std::vector<judge::LabPlan> plans_of(const CourseTree& tree, const std::string& seed,
                                     const fs::path& models) {
  std::vector<judge::LabPlan> plans = full_plan(tree.labs, seed, models);
  if (seed != kSeeds.front())
    for (judge::LabPlan& one : plans)
      std::erase_if(one.cases, [](const course::Case& of) { return !of.hidden; });
  return plans;
}

/// What check compares a public case with.
check::ExpectedFiles kept(const CourseTree& tree, const judge::LabPlan& lab, const course::Case& of) {
  const fs::path folder = check::expected_folder(tree.course, lab.lab);
  return {folder / of.file, of.is_mesh() ? fs::path() : folder / (of.name + ".mask.png")};
}

}  // namespace

std::string renderer_here(const CourseTree& tree, const std::string& context) {
  return check::renderer_of(studio(tree, tree.labs.front(), context));
}

void draw_cases(const CourseTree& tree, const std::string& context, const fs::path& out) {
  for (const char* seed : kSeeds) {
    const std::vector<judge::LabPlan> plans = plans_of(tree, seed, out.parent_path() / "models");
    in_parallel(processors(), plans.size(), [&](std::size_t i) {
      const check::Studio own = studio(tree, plans[i].lab, context);
      const fs::path to = out / seed / plans[i].lab.folder;
      fs::create_directories(to);
      if (plans[i].cases.empty()) return;
      check::draw_all(own, plans[i].cases, to);
      check::draw_all(own, plans[i].masks(), to / "mask");
    });
  }
}

std::vector<std::string> wrongly_passed(const CourseTree& tree, const std::string& context,
                                        const std::function<void(const std::string&)>& say) {
  std::vector<std::string> faults;
  References course(tree.course, tree.build, tree.cache, context);
  // By what this renderer draws, as grade has it, or by what is kept, as check has it: one of them is enough.
  const auto is_passed = [&](const judge::LabPlan& lab, const std::string& step, const fs::path& folder) {
    return std::all_of(lab.cases.begin(), lab.cases.end(), [&](const course::Case& of) {
      const fs::path picture = folder / of.file;
      return of.step != step || check::judge(of, course.expected(lab, of), picture).passed ||
             (!of.hidden && check::judge(of, kept(tree, lab, of), picture).passed);
    });
  };
  for (const judge::LabPlan& lab : full_plan(tree.labs, kSeeds.front(), tree.cache / "models")) {
    course.prepare(lab);
    for (const course::Step& step : lab.lab.steps)
      if (is_passed(lab, step.id, course.starter_folder(lab)))
        faults.push_back(fmt::format("the starter passes step {}", step.id));
    const std::vector<const material::Mutant*> mutants = course.mutants_of(lab.lab);
    std::vector<char> passed(mutants.size());
    in_parallel(processors(), mutants.size(), [&](std::size_t i) {
      passed[i] = is_passed(lab, mutants[i]->step, course.drawn_by(lab, *mutants[i]));
    });
    for (std::size_t i = 0; i < mutants.size(); ++i)
      if (passed[i] != 0)
        faults.push_back(fmt::format("mutant {} passes step {}", mutants[i]->name, mutants[i]->step));
    say(fmt::format("lab {}, {} mutants", lab.lab.number, mutants.size()));
  }
  return faults;
}

std::vector<Spread> spreads(const CourseTree& tree, const fs::path& drawn, const std::string& reference) {
  std::vector<std::string> renderers;
  for (const fs::directory_entry& entry : fs::directory_iterator(drawn))
    if (fs::exists(entry.path() / check::kRendererFile))
      renderers.push_back(entry.path().filename().string());
  const std::map<std::string, Place> places = course::first_places(tree.course);
  std::vector<Spread> all;
  for (const course::Lab& lab : tree.labs)
    for (const course::GradedCase& one : lab.cases)
      all.push_back({lab.number,
                     one.name,
                     name_of(unit_of(one.view)),
                     !one.hidden && places.at(one.step).file.starts_with("shaders/"),
                     {}});
  for (const char* seed : kSeeds)
    for (const judge::LabPlan& lab : plans_of(tree, seed, drawn / "models"))
      in_parallel(processors(), lab.cases.size(), [&](std::size_t i) {
        const course::Case& of = lab.cases[i];
        const fs::path folder = fs::path(seed) / lab.lab.folder;
        check::ExpectedFiles expected = kept(tree, lab, of);
        if (of.hidden) {
          expected.reference = drawn / reference / folder / of.file;
          if (!of.is_mesh()) expected.mask = drawn / reference / folder / "mask" / (of.name + ".png");
        }
        const auto place = std::find_if(all.begin(), all.end(), [&](const Spread& spread) {
          return spread.lab == lab.lab.number && spread.name == of.name;
        });
        for (const std::string& renderer : renderers) {
          const double error = check::judge(of, expected, drawn / renderer / folder / of.file).error;
          double& most = place->by[renderer];
          most = std::isnan(error) || std::isnan(most) ? std::nan("") : std::max(most, error);
        }
      });
  return all;
}

}  // namespace texel::grade
