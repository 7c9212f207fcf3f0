// SPDX-License-Identifier: MIT
// texel: the course's command line.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "commands.hpp"

namespace texel::tools {
namespace {

constexpr const char* kExitCodes =
    "Exit codes: 0 holds, 1 differs, 2 wrong usage, 3 could not load, render or compare.";

void add_compare(CLI::App& app, CompareOptions& options) {
  CLI::App* command = app.add_subcommand("compare", "How far one picture is from another");
  command->footer(kExitCodes);
  command
      ->add_option("REF", options.reference,
                   "The picture that is right: .png, .jpg, .gif, .bmp, .tga or .pfm")
      ->required();
  command->add_option("IMG", options.image, "The picture in question, of the same size")->required();
  command->add_flag("--json", options.json, "Print one JSON object");
  command->add_option("--mask", options.mask, "Only pixels where this picture is not black count");
  command->add_option("--heatmap", options.heatmap, "Write where they differ as a .png");
  command->add_option("--flip-heatmap", options.flip_heatmap,
                      "Write where a viewer sees the difference (FLIP) as a .png");
  command->add_option("--max", options.max, "Limit of the largest difference over R, G and B");
  command->add_option("--mean", options.mean, "Limit of the mean over samples");
  command->add_option("--p99", options.p99,
                      "Limit of the 99th percentile over pixels of each pixel's largest");
  command->add_option("--flip", options.flip, "Limit of the mean of FLIP, 0 to 1");
  command->add_option("--ppd", options.pixels_per_degree,
                      "FLIP's pixels for each degree of view, 1 to 1000 [67.02]");
  command->add_flag("--edge-tolerance", options.edge_tolerance,
                    "At edges, let a pixel of one picture fit any of the 3x3 in the other");
  command
      ->add_option("--unit", options.unit,
                   "How two .pfm files are compared: own unit, degrees between directions, texels between "
                   "texture coordinates, or auto: degrees when REF holds unit vectors (or zero) only [auto]")
      ->check(CLI::IsMember({"auto", "own", "degrees", "texels"}));
  command->add_option("--texels", options.texels, "For --unit texels: the texture's size, 512 or 512x256")
      ->delimiter('x')
      ->expected(1, 2)
      ->check(CLI::Range(1, 1 << 20));
}

void add_gallery(CLI::App& app, GalleryOptions& options, bool& list) {
  CLI::App* command = app.add_subcommand("gallery", "Draw every lab's looks and the page that shows them");
  command->add_option("--out", options.out, "Folder for the page and the pictures [out/gallery]");
  command->add_option("--lab", options.labs, "Draw only this lab (may be given again)")
      ->check(CLI::Range(1, 99));
  command->add_option("--heroes", options.heroes,
                      "Folder for the heroes, small and cut to 3:2, as the README shows them");
  command->add_flag("--list", list, "Print as Markdown which command draws which picture of the sources");
}

void add_bench(CLI::App& app, BenchOptions& options) {
  CLI::App* command =
      app.add_subcommand("bench", "Measure every method's error and cost, and show one against the other");
  command->footer(
      "Exit codes: 0 holds, 1 an error is not that of --against, 2 wrong usage, 3 could not measure.");
  command->add_option("LAB", options.labs, "Numbers of labs [all]")->check(CLI::Range(1, 99));
  command->add_option("--out", options.out, "Folder for the page with the plots [out/bench]");
  command->add_option("--json", options.json, "Write all figures as JSON");
  command->add_option(
      "--markdown", options.markdown,
      "Write the tables as Markdown, and the plots into a folder of the file's name beside it");
  command->add_option("--from", options.from, "Measure nothing: take what an earlier --json wrote");
  command->add_option("--against", options.against, "Compare the errors with those of an earlier --json");
  command->add_flag("--errors-only", options.errors_only, "Time nothing");
}

void add_mutants(CLI::App& app, MutantsOptions& options) {
  CLI::App* command = app.add_subcommand(
      "mutants", "Make small wrong changes in a copy of the tree, and see whether the tests notice");
  command->footer(
      "Exit codes: 0 at least 90 % caught, 1 fewer, 2 wrong usage, 3 a mutant does not apply or build.");
  command->add_option("--catalogue", options.catalogue, "Folder of the mutants [tests/mutants]");
  command->add_option("--root", options.root, "The tree [the source tree]");
  command->add_option("--only", options.only, "Names with commas between them, or a file with one a line")
      ->delimiter(',');
  command->add_option("--report", options.report,
                      "Write each result as it comes into this .md or .json; it holds earlier ones too");
  command->add_option("--work", options.work, "Folder for the copy, its build and the logs [build/mutants]");
}

/// CLI11 says only that a command is needed; this names the nearest.
void reject_unknown_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (std::find(names.begin(), names.end(), argv[1]) != names.end()) return;
  const std::string near = nearest(argv[1], names);
  throw Error::usage(fmt::format("there is no command '{}'", argv[1]),
                     near.empty() ? fmt::format("the commands are {}", fmt::join(names, ", "))
                                  : fmt::format("did you mean '{}'?", near));
}

Exit run(int argc, char** argv) {
  CLI::App app("The course's command line", "texel");
  app.set_version_flag("--version", TEXEL_VERSION, "Print the version and exit");
  app.require_subcommand(1);
  CompareOptions compare_options;
  GalleryOptions gallery_options;
  BenchOptions bench_options;
  MutantsOptions mutants_options;
  bool list_only = false;
  app.add_subcommand("list", "The labs at a glance");
  add_gallery(app, gallery_options, list_only);
  add_compare(app, compare_options);
  add_bench(app, bench_options);
  add_mutants(app, mutants_options);
  reject_unknown_command(app, argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {  // --help, --version
    app.exit(done);
    return Exit::holds;
  } catch (const CLI::ParseError& error) {
    throw Error::usage(error.what(), "see --help");
  }
  if (app.got_subcommand("list")) return list();
  if (app.got_subcommand("compare")) return compare(compare_options);
  if (app.got_subcommand("bench")) return bench(bench_options);
  if (app.got_subcommand("mutants")) return mutants(mutants_options);
  return list_only ? list_sources() : gallery(gallery_options);
}

}  // namespace
}  // namespace texel::tools

int main(int argc, char** argv) {
  try {
    return static_cast<int>(texel::tools::run(argc, argv));
  } catch (const texel::Error& error) {
    std::fprintf(stderr, "texel: %s\n", error.what());
    return static_cast<int>(error.exit_code());
  } catch (const std::exception& error) {  // out of memory, a fault of ours
    std::fprintf(stderr, "texel: %s\n", error.what());
    return static_cast<int>(texel::Exit::failed);
  }
}
