// SPDX-License-Identifier: MIT
// Measures what docs/performance.md says, and writes it. No figure fails: the program ends with an error only
// where a result is missing or wrong.
#include <CLI/CLI.hpp>
#include <cstdlib>

#include "core/files.hpp"
#include "core/scratch_folder.hpp"
#include "core/terminal.hpp"
#include "measures.hpp"

int main(int argc, char** argv) {
  using namespace texel::bench;
  const std::pair<const char*, void (*)(const Options&, Report&)> parts[] = {
      {"snapshots", measure_snapshots}, {"warm", measure_one_more},   {"batch", measure_batches},
      {"grading", measure_grading},     {"kernels", measure_kernels}, {"frames", measure_frames},
      {"start", measure_window_start},  {"peers", measure_peers},     {"waits", measure_waits},
      {"tests", measure_tests}};
  std::vector<std::string> names;
  for (const auto& [name, measure] : parts) names.emplace_back(name);

  Options options;
  std::string only, json, markdown;
  CLI::App app("Measure the course's programs beside others");
  app.add_option("--rounds", options.rounds, "Rounds of each pair [11]")->check(CLI::Range(1, 1000));
  app.add_option("--only", only, "One part alone")->check(CLI::IsMember(names));
  app.add_option(
      "--first-run-before", options.first_run_before,
      "An earlier commit's tree, in which ./run build was typed: a student's first ./run beside it");
  app.add_option("--saves-before", options.saves_before,
                 "The same: from a save to the verdict, and ./run test, beside it");
  app.add_option("--json", json, "Write all figures into this file");
  app.add_option("--markdown", markdown, "Write the report into this file");
  CLI11_PARSE(app, argc, argv);
  return texel::run_main("performance", [&] {
    // With the driver's cache of compiled shaders the second start would be another one than the first.
    ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    const texel::ScratchFolder folder;
    options.work = folder.path();
    Report report;
    for (const auto& [name, measure] : parts) {
      if (!only.empty() && only != name) continue;
      measure(options, report);
      // Now, so that a fault in a later part loses nothing.
      if (!json.empty()) texel::write_file(json, report.as_json());
      if (!markdown.empty())
        texel::write_file(markdown, report.as_markdown(options.rounds, options.long_rounds()));
    }
    return texel::Exit::holds;
  });
}
