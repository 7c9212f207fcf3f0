// SPDX-License-Identifier: MIT
#include "grade/renderers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "bench/results.hpp"
#include "commands.hpp"
#include "core/files.hpp"
#include "renderers/table.hpp"

namespace texel::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFilters = "filters.json";

void print_now(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

/// "mesa22" of "mesa22_llvmpipe_egl".
std::string version_of(const std::string& renderer) {
  return renderer.substr(0, renderer.find('_'));
}

void errors_of_lab_1(const fs::path& work, const fs::path& file) {
  BenchOptions options;
  options.labs = {1}, options.out = work, options.json = file, options.errors_only = true;
  bench(options);
}

/// What the folders of `drawn` show. Throws Error (exit 3).
RendererReport report_on(const grade::CourseTree& tree, const fs::path& drawn, const std::string& reference) {
  RendererReport report;
  for (const grade::Spread& spread : grade::spreads(tree, drawn, reference)) {
    RendererReport::Row row{spread.lab, spread.name, spread.unit, {}};
    for (const auto& [renderer, error] : spread.by) {
      double& most = row.by[group_of(renderer)];
      // NaN, where nothing could be compared, is further than anything.
      most = error >= 0 ? std::max(most, error) : std::numeric_limits<double>::infinity();
    }
    report.cases.push_back(std::move(row));
  }
  std::map<std::string, RendererReport::Row> filters;
  for (const fs::directory_entry& entry : fs::directory_iterator(drawn)) {
    const std::string name = entry.path().filename().string();
    if (fs::exists(entry.path() / grade::kRendererFile)) {
      const std::string says = read_file(entry.path() / grade::kRendererFile);
      report.drawn_by[name] = says.substr(0, says.find('\n'));
    }
    if (!fs::exists(entry.path() / kFilters)) continue;
    for (const BenchResult& result : read_report_json(entry.path() / kFilters).results)
      if ((result.method == "anisotropic" || result.method == "supersampled") &&
          result.case_name != kAllCases) {
        RendererReport::Row& row = filters[result.case_name];
        row.lab = 1, row.name = result.case_name, row.unit = "rms";
        row.by[fmt::format("{}, {}", result.method, version_of(name))] = result.rms;
      }
  }
  for (auto& [name, row] : filters) report.filters.push_back(std::move(row));
  return report;
}

}  // namespace

Exit renderers(const RenderersCommand& command) {
  const fs::path root = course_root(), out = fs::absolute(command.out);
  const grade::CourseTree tree{root, course_build(),
                               command.cache.empty() ? root / "build/grade" : command.cache, chosen_labs({})};
  make_folder(out);
  std::vector<std::string> faults;
  for (const grade::Renderer& renderer : grade::known_renderers(course_build() / "tools/librsqrt.so")) {
    if (!command.only.empty() &&
        std::find(command.only.begin(), command.only.end(), renderer.name) == command.only.end())
      continue;
    if (command.mutants) {
      const std::vector<std::string> passed = grade::passed_by(renderer, tree, print_now);
      faults.insert(faults.end(), passed.begin(), passed.end());
    } else if (!command.judge_only) {
      const std::string drawn = grade::draw_by(renderer, tree, out);
      print_now(fmt::format("{}: {}", renderer.name, drawn.empty() ? "not here" : "drawn"));
      if (!drawn.empty() && renderer.name == "llvmpipe_egl")
        errors_of_lab_1(out / "bench", out / drawn / kFilters);
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
  bool holds = true;
  for (const RendererReport::Row& row : report.cases)
    for (const course::Lab& lab : tree.labs)
      for (const course::GradedCase& one : lab.cases)
        for (const auto& [group, error] : row.by)
          if (lab.number == row.lab && one.name == row.name && one.limit < 3 * error) {
            print_now(fmt::format("lab {}, {}: the limit {:g} leaves no room for {:.3g} by {}", row.lab,
                                  row.name, one.limit, error, group));
            holds = false;
          }
  return holds ? Exit::holds : Exit::differs;
}

}  // namespace texel::tools
