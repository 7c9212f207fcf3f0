// SPDX-License-Identifier: MIT
#include "grade/renderers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "bench/results.hpp"
#include "check/check.hpp"
#include "commands.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/process.hpp"
#include "core/terminal.hpp"
#include "course/markers.hpp"
#include "course_commands.hpp"
#include "renderers/table.hpp"

namespace texel::commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFilters = "filters.json";
/// Of the files in which tests say what share of their limits they used, as tests/support/tolerance.hpp has
/// it.
constexpr const char* kTolerances = "tolerances";

void print_now(const std::string& line) {
  fmt::print("{}\n", line);
  flush_output();
}

/// "mesa22" of "mesa22_llvmpipe_egl".
std::string version_of(const std::string& renderer) {
  return renderer.substr(0, renderer.find('_'));
}

bool is_hardware(const std::string& renderer) {
  return renderer.ends_with("_hardware_egl");
}

void errors_of_lab_1(const fs::path& work, const fs::path& file) {
  BenchOptions options;
  options.labs = {1}, options.out = work, options.json = file, options.errors_only = true;
  bench(options);
}

/// Runs the tests that draw, and has them write into `folder`. Returns what failed.
std::vector<std::string> run_tests(const grade::Renderer& renderer, const fs::path& folder) {
  fs::remove_all(folder);
  tools::make_folder(folder);
  Ran ran;
  grade::with(renderer, [&] {
    ::setenv("TEXEL_TOLERANCES", folder.c_str(), 1);
    ran = run_program({"ctest", "--test-dir", tools::course_build().string(), "--label-regex", "limits",
                       "--parallel", std::to_string(processors()), "--no-tests=error"},
                      true);
    ::unsetenv("TEXEL_TOLERANCES");
  });
  std::vector<std::string> failed;
  std::istringstream lines(ran.output);
  for (std::string line; std::getline(lines, line);)
    if (line.find("***") != std::string::npos) failed.push_back(fmt::format("{}: {}", renderer.name, line));
  if (failed.empty() && ran.exit_code != 0) throw Error::failed("the tests did not run: " + ran.output);
  return failed;
}

/// Adds what a folder of `run_tests` says. `tests` has a row for each test and assertion.
void add_tests(const fs::path& folder, const std::string& group,
               std::map<std::pair<std::string, std::string>, RendererReport::Row>& tests) {
  if (!fs::exists(folder)) return;
  std::map<std::pair<std::string, std::string>, double> own;
  for (const fs::directory_entry& file : fs::directory_iterator(folder)) {
    std::istringstream lines(read_file(file.path()));
    std::string test, assertion, share;
    while (std::getline(lines, test, '\t') && std::getline(lines, assertion, '\t') &&
           std::getline(lines, share)) {
      double& most = own[{test, assertion}];
      most = std::max(most, std::stod(share));
    }
  }
  for (const auto& [name, share] : own) {
    const auto [place, is_new] = tests.try_emplace(name);
    RendererReport::Row& row = place->second;
    row.name = name.first, row.unit = name.second;
    row.least = is_new ? share : std::min(row.least, share);
    row.by[group] = std::max(row.by[group], share);
  }
}

/// Whether a page in a browser judges the case, and so by a graphics card: public ones of steps in shaders.
bool is_judged_in_a_page(const grade::CourseTree& tree, const grade::Spread& spread,
                         const std::map<std::string, Place>& places) {
  for (const course::Lab& lab : tree.labs)
    for (const course::GradedCase& one : lab.cases)
      if (lab.number == spread.lab && one.name == spread.name)
        return !one.hidden && places.at(one.step).file.starts_with("shaders/");
  return false;
}

/// What the folders of `drawn` show. Throws Error (exit 3).
RendererReport report_on(const grade::CourseTree& tree, const fs::path& drawn, const std::string& reference) {
  RendererReport report;
  const std::map<std::string, Place> places = course::first_places(tree.course);
  for (const grade::Spread& spread : grade::spreads(tree, drawn, reference)) {
    RendererReport::Row row{spread.lab, spread.name, spread.unit, {}, 0};
    const bool is_of_a_page = is_judged_in_a_page(tree, spread, places);
    for (const auto& [renderer, error] : spread.by) {
      if (is_hardware(renderer) && !is_of_a_page) continue;
      double& most = row.by[group_of(renderer)];
      // NaN, where nothing could be compared, is further than anything.
      most = error >= 0 ? std::max(most, error) : std::numeric_limits<double>::infinity();
    }
    report.cases.push_back(std::move(row));
  }
  std::map<std::string, RendererReport::Row> filters;
  std::map<std::pair<std::string, std::string>, RendererReport::Row> tests;
  for (const fs::directory_entry& entry : fs::directory_iterator(drawn)) {
    const std::string name = entry.path().filename().string();
    if (fs::exists(entry.path() / check::kRendererFile)) {
      const std::string says = read_file(entry.path() / check::kRendererFile);
      report.drawn_by[name] = says.substr(0, says.find('\n'));
    }
    add_tests(entry.path() / kTolerances, group_of(name), tests);
    if (!fs::exists(entry.path() / kFilters)) continue;
    for (const BenchResult& result : read_report_json(entry.path() / kFilters).results)
      if ((result.method == "anisotropic" || result.method == "supersampled") &&
          result.case_name != kAllCases) {
        RendererReport::Row& row = filters[result.case_name];
        row.lab = 1, row.name = result.case_name, row.unit = "rms";
        row.by[fmt::format("{}, {}", result.method, version_of(name))] = result.rms;
      }
  }
  for (auto& [name, row] : tests) report.tests.push_back(std::move(row));
  for (auto& [name, row] : filters) report.filters.push_back(std::move(row));
  return report;
}

}  // namespace

Exit renderers(const RenderersCommand& command) {
  const fs::path root = tools::course_root(), out = fs::absolute(command.out);
  const grade::CourseTree tree{root, tools::course_build(),
                               command.cache.empty() ? root / "build/grade" : command.cache,
                               tools::chosen_labs(command.labs)};
  tools::make_folder(out);
  std::vector<std::string> faults;
  for (const grade::Renderer& renderer :
       grade::known_renderers(tools::course_build() / "teach/commands/librsqrt.so")) {
    if (!command.only.empty() &&
        std::find(command.only.begin(), command.only.end(), renderer.name) == command.only.end())
      continue;
    if (command.mutants) {
      const std::vector<std::string> passed = grade::passed_by(renderer, tree, print_now);
      faults.insert(faults.end(), passed.begin(), passed.end());
    } else if (!command.judge_only) {
      const std::string drawn = grade::draw_by(renderer, tree, out);
      print_now(fmt::format("{}: {}", renderer.name, drawn.empty() ? "not on this machine" : "drawn"));
      if (drawn.empty()) continue;
      if (renderer.name == "llvmpipe_egl" || is_hardware(drawn))
        grade::with(renderer, [&] { errors_of_lab_1(out / "bench", out / drawn / kFilters); });
      // The tests that draw hold what software reaches, which does not round a vertex's place as a GPU does.
      if (is_hardware(drawn)) continue;
      const std::vector<std::string> failed = run_tests(renderer, out / drawn / kTolerances);
      print_now(fmt::format("{}: tested, {} failed", renderer.name, failed.size()));
      faults.insert(faults.end(), failed.begin(), failed.end());
    }
  }
  for (const std::string& fault : faults) print_now(fault);
  if (command.mutants) return faults.empty() ? Exit::holds : Exit::differs;
  const RendererReport report = report_on(tree, out, command.reference);
  const std::string section = renderers_markdown(report, tree.labs);
  if (!command.json.empty()) write_file(command.json, to_json(report));
  if (!command.markdown.empty()) {
    const std::string text = read_file(command.markdown);
    write_file(command.markdown, text.substr(0, text.find(fmt::format("\n{}", kRenderersTitle))) + section);
  }
  if (command.json.empty() && command.markdown.empty()) print_now(section);
  bool holds = faults.empty();
  for (const RendererReport::Row& row : report.cases)
    for (const course::Lab& lab : tree.labs)
      for (const course::GradedCase& one : lab.cases)
        for (const auto& [group, error] : row.by)
          if (lab.number == row.lab && one.name == row.name && one.limit < 3 * error) {
            print_now(fmt::format("lab {}, {}: the limit {:g} is too small for the difference {:.3g} of {}",
                                  row.lab, row.name, one.limit, error, group));
            holds = false;
          }
  for (const RendererReport::Row& row : report.tests)
    if (row.room(1) < 3) {
      print_now(fmt::format("{}: {} leaves room for {:.2g} times the spread between renderers, not for 3",
                            row.name, row.unit, row.room(1)));
      holds = false;
    }
  return holds ? Exit::holds : Exit::differs;
}

}  // namespace texel::commands
