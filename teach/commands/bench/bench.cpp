// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/stopwatch.hpp"
#include "course/batch.hpp"
#include "course_commands.hpp"
#include "processes.hpp"
#include "renderers/table.hpp"
#include "report.hpp"

namespace texel::commands {
namespace {

namespace fs = std::filesystem;

/// How long the frames of a lab are timed in all, and of one case at most. With the truths to be computed
/// this keeps a lab below 40 s on two cores.
constexpr double kSecondsALab = 12, kSecondsACase = 2;

/// What the lab's program reads with --bench.
std::string case_list(const course::Lab& lab, bool errors_only) {
  const double seconds =
      errors_only ? 0 : std::min(kSecondsACase, kSecondsALab / static_cast<double>(lab.bench.size()));
  return course::to_json(course::BenchList{seconds, lab.bench});
}

/// Runs the lab's program and reads what it wrote.
BenchReport measured(const course::Lab& lab, const fs::path& folder, bool errors_only) {
  const fs::path cases = folder / (lab.folder + "-cases.json"),
                 output = folder / (lab.folder + "-times.json");
  write_file(cases, case_list(lab, errors_only));
  int status = 0;
  tools::run_all({{tools::program_of(lab), "--bench", cases.string(), "--report", output.string()}}, 1,
                 [&](std::size_t, int s) { status = s; });
  if (status != 0) throw Error::failed("could not measure " + lab.program(), {}, "see its message above");
  return read_lab_output(output, lab);
}

BenchReport measure(const std::vector<course::Lab>& labs, const BenchOptions& options) {
  tools::make_folder(options.out);
  BenchReport all;
  const Stopwatch whole;
  for (const course::Lab& lab : labs) {
    fmt::print(stderr, "lab {} {}: {} cases\n", lab.number, lab.title, lab.bench.size());
    const Stopwatch one;
    BenchReport report = measured(lab, options.out, options.errors_only);
    all.renderer = report.renderer;
    std::move(report.results.begin(), report.results.end(), std::back_inserter(all.results));
    fmt::print(stderr, "  {:.0f} s, {:.0f} s in all\n", one.milliseconds() / 1e3, whole.milliseconds() / 1e3);
  }
  return all;
}

void write_markdown(const std::vector<LabResults>& labs, const std::string& renderer, const std::string& gpu,
                    const fs::path& file) {
  const fs::path folder = file.parent_path() / file.stem();
  tools::make_folder(folder);
  for (const LabResults& lab : labs) {
    const std::vector<Plot> drawn = plots(lab);
    for (std::size_t i = 0; i < drawn.size(); ++i) write_file(folder / plot_file(lab.lab, i), svg(drawn[i]));
  }
  write_file(file, bench_markdown(labs, renderer, gpu, file.stem().string()) +
                       renderers_markdown(read_renderers(tools::course_root() / "docs/renderers.json"),
                                          tools::course_labs()));
}

/// Draws what the page shows of each result, all labs at the same time.
void draw_pictures(const std::vector<LabResults>& labs, const fs::path& out) {
  fmt::print(stderr, "drawing the page's pictures\n");
  std::vector<tools::Command> commands;
  for (const LabResults& lab : labs) {
    std::vector<course::Case> cases;
    for (const course::BenchCase& bench : lab.lab.bench)
      for (const BenchResult& result : lab.results)
        if (result.case_name == bench.name)
          for (course::Case& picture : pictures_of(bench, result)) cases.push_back(std::move(picture));
    const fs::path folder = out / kPictures / lab.lab.folder, list = folder / "batch.json";
    tools::make_folder(folder);
    write_file(list, course::to_batch(cases));
    commands.push_back({tools::program_of(lab.lab), "--batch", list.string(), "--out", folder.string()});
  }
  tools::run_all(commands, static_cast<int>(processors()), [&](std::size_t i, int status) {
    if (status != 0)
      throw Error::failed("could not draw the pictures of " + labs[i].lab.program(), {},
                          "see its message above");
  });
}

void write_page(const std::vector<LabResults>& labs, const std::string& renderer, const fs::path& out) {
  draw_pictures(labs, out);
  const fs::path page = out / "index.html";
  write_file(page, bench_page(labs, renderer));
  fmt::print("\nplots: {}\n", page.string());
}

}  // namespace

Exit bench(const BenchOptions& options) {
  std::vector<course::Lab> labs = tools::chosen_labs(options.labs);
  std::erase_if(labs, [](const course::Lab& lab) { return lab.bench.empty(); });
  if (options.from.empty() && !std::all_of(labs.begin(), labs.end(), tools::knows_truth)) {
    fmt::print("Nothing is measured: this tree does not contain the right answers to compare with.\n");
    return Exit::holds;
  }
  const BenchReport report = options.from.empty() ? measure(labs, options) : read_report_json(options.from);
  const BenchReport by_gpu = options.gpu.empty() ? BenchReport{} : read_report_json(options.gpu);
  const std::vector<LabResults> results = by_lab(labs, report, by_gpu);
  if (!options.json.empty()) write_file(options.json, to_json(report));
  if (!options.markdown.empty()) write_markdown(results, report.renderer, by_gpu.renderer, options.markdown);
  if (!options.against.empty()) {
    const BenchReport then = read_report_json(options.against);
    if (then.renderer != report.renderer)
      for (const course::Lab& lab : labs)
        for (const std::string& method : lab.driver_methods)
          fmt::print("lab {}, {}: not compared, it depends on the driver, which was {}\n", lab.number, method,
                     then.renderer);
    const std::vector<std::string> lines = differences(then, report, labs);
    for (const std::string& line : lines) fmt::print("{}\n", line);
    fmt::print("{} of {} errors differ from {}\n", lines.size(), report.results.size(),
               options.against.string());
    return lines.empty() ? Exit::holds : Exit::differs;
  }
  if (options.from.empty() || (options.markdown.empty() && options.json.empty())) {
    for (const LabResults& lab : results) fmt::print("{}", terminal_table(lab));
    write_page(results, report.renderer, options.out);
  }
  return Exit::holds;
}

}  // namespace texel::commands
