// SPDX-License-Identifier: MIT
// What scripts ask of the grader: ./run expected, renderers, marks and performance.
#include <fmt/format.h>

#include <cmath>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/json.hpp"
#include "core/terminal.hpp"
#include "course/batch.hpp"
#include "course_commands.hpp"
#include "grade/course_tree.hpp"
#include "grade/hidden_cases.hpp"

namespace texel::commands {
namespace {

void print_now(const std::string& line) {
  fmt::print("{}\n", line);
  flush_output();
}

/// null where nothing could be compared.
Json figure(double value) {
  return std::isnan(value) ? Json() : Json(value);
}

Json to_json(const std::vector<grade::Spread>& spreads) {
  Json all = Json::array();
  for (const grade::Spread& one : spreads) {
    Json by = Json::object();
    for (const auto& [renderer, error] : one.by) by[renderer] = figure(error);
    all.push_back({{"lab", one.lab},
                   {"case", one.name},
                   {"unit", one.unit},
                   {"in_pages", one.is_in_pages},
                   {"by", by}});
  }
  return all;
}

Json to_json(const judge::StepResult& step) {
  Json cases = Json::array();
  for (const judge::CaseResult& one : step.cases)
    cases.push_back({{"case", one.name},
                     {"passed", one.passed()},
                     {"error", figure(one.error)},
                     {"limit", one.limit},
                     {"unit", name_of(one.unit())}});
  return {{"passed", step.status == judge::Status::passed}, {"score", step.score}, {"cases", cases}};
}

Json to_json(const std::vector<grade::JudgedSolution>& solutions) {
  Json all = Json::array();
  for (const grade::JudgedSolution& one : solutions) {
    Json seeds = Json::array();
    for (const judge::StepResult& step : one.by_seed) seeds.push_back(to_json(step));
    all.push_back({{"step", one.by_seed.front().id},
                   {"name", one.name},
                   {"is_right", one.is_right},
                   {"called", one.called},
                   {"is_called", one.is_called},
                   {"seeds", seeds}});
  }
  return all;
}

}  // namespace

grade::CourseTree course_tree(const std::vector<int>& labs, const std::filesystem::path& cache) {
  const std::filesystem::path root = tools::course_root();
  return {root, tools::course_build(), cache.empty() ? root / "build/grade" : cache,
          tools::chosen_labs(labs)};
}

Exit expected(const grade::CourseTree& tree) {
  grade::write_expected(tree, print_now);
  return Exit::holds;
}

Exit cases(const CasesCommand& command) {
  const grade::CourseTree tree = course_tree(command.labs, command.cache);
  if (command.what == "renderer") {
    fmt::print("{}\n", grade::renderer_here(tree, command.context));
  } else if (command.what == "draw") {
    grade::draw_cases(tree, command.context, std::filesystem::absolute(command.out));
  } else if (command.what == "batch") {
    make_folder(command.out);
    for (const judge::LabPlan& plan : grade::full_plan(tree.labs, command.seed, command.out / "models"))
      write_file(command.out / (plan.lab.folder + ".json"), course::to_batch(plan.cases));
  } else if (command.what == "mutants") {
    write_file(command.out, to_text(grade::wrongly_passed(tree, command.context, print_now)));
  } else if (command.what == "spreads") {
    write_file(
        command.out,
        to_text(to_json(grade::spreads(tree, std::filesystem::absolute(command.drawn), command.reference))));
  } else {
    write_file(command.out,
               to_text(to_json(grade::judged_solutions(tree, command.seeds, command.places, print_now))));
  }
  return Exit::holds;
}

}  // namespace texel::commands
