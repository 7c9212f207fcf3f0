// SPDX-License-Identifier: MIT
// texel: the course's command line.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "commands.hpp"

namespace texel::tools {
namespace {

constexpr const char* kExitCodes =
    "Exit codes: 0 holds, 1 differs, 2 wrong usage, 3 could not load, render or compare.";

void add_compare(CLI::App& app, CompareOptions& options) {
  CLI::App* command = app.add_subcommand("compare", "Measure how far one picture is from another");
  command->footer(kExitCodes);
  command->add_option("REF", options.reference, "The right picture: .png, .jpg, .gif, .bmp, .tga or .pfm")
      ->required();
  command->add_option("IMG", options.image, "The picture to compare with it, of the same size")->required();
  command->add_flag("--json", options.json, "Print one JSON object");
  command->add_option("--mask", options.mask, "Count only pixels where this picture is not black");
  command->add_option("--heatmap", options.heatmap, "Write a .png of where they differ");
  command->add_option("--flip-heatmap", options.flip_heatmap,
                      "Write a .png of where a viewer sees the difference (FLIP)");
  command->add_option("--max", options.max, "Limit of the largest difference over R, G and B");
  command->add_option("--mean", options.mean, "Limit of the mean over all samples");
  command->add_option("--p99", options.p99,
                      "Limit of the 99th percentile over the pixels' largest differences");
  command->add_option("--flip", options.flip, "Limit of the mean of FLIP, 0 to 1");
  command->add_option("--ppd", options.pixels_per_degree,
                      "Pixels per degree of view for FLIP, 1 to 1000 [67.02]");
  command->add_flag(
      "--edge-tolerance", options.edge_tolerance,
      "At edges, accept a pixel that equals one of the 3x3 pixels around it in the other picture");
  command
      ->add_option(
          "--unit", options.unit,
          "How two .pfm files are compared: in their own unit, degrees between directions, texels between "
          "texture coordinates, or auto: degrees if REF holds only unit vectors or zeros [auto]")
      ->check(CLI::IsMember({"auto", "own", "degrees", "texels"}));
  command->add_option("--texels", options.texels, "For --unit texels: the texture's size, as 512 or 512x256")
      ->delimiter('x')
      ->expected(1, 2)
      ->check(CLI::Range(1, 1 << 20));
}

void add_gallery(CLI::App& app, GalleryOptions& options, bool& list) {
  CLI::App* command = app.add_subcommand("gallery", "Draw every lab's looks, and a page that shows them");
  command->add_option("--out", options.out, "Folder for the page and the pictures [out/gallery]");
  command->add_option("--lab", options.labs, "Draw only this lab; repeat the option for several labs")
      ->check(CLI::Range(1, 99));
  command->add_option("--heroes", options.heroes,
                      "Folder for one small picture of each lab, cut to 3:2, as in the README");
  command->add_flag("--list", list,
                    "Print a Markdown table: which command draws which picture of the sources");
}

void add_bench(CLI::App& app, BenchOptions& options) {
  CLI::App* command =
      app.add_subcommand("bench", "Measure every method's error and cost, and plot one against the other");
  command->footer(
      "Exit codes: 0 holds, 1 an error differs from --against, 2 wrong usage, 3 could not measure.");
  command->add_option("LAB", options.labs, "Numbers of labs [all]")->check(CLI::Range(1, 99));
  command->add_option("--out", options.out, "Folder for the page with the plots [out/bench]");
  command->add_option("--json", options.json, "Write all figures as JSON");
  command->add_option(
      "--markdown", options.markdown,
      "Write the tables as Markdown, and the plots into a folder with the file's name beside it");
  command->add_option("--from", options.from, "Measure nothing: read the figures of an earlier --json");
  command->add_option("--against", options.against, "Compare the errors with those of an earlier --json");
  command->add_flag("--errors-only", options.errors_only, "Measure errors, but no times");
}

void add_mutants(CLI::App& app, MutantsOptions& options) {
  CLI::App* command = app.add_subcommand(
      "mutants", "Make small wrong changes in a copy of the tree, and check that the tests notice");
  command->footer(
      "Exit codes: 0 at least 90 % caught, 1 fewer, 2 wrong usage, 3 a mutant does not apply or compile.");
  command->add_option("--catalogue", options.catalogue, "Folder of the mutants [tests/mutants]");
  command->add_option("--root", options.root, "The tree [the source tree]");
  command->add_option("--only", options.only, "Names separated by commas, or a file with one name per line")
      ->delimiter(',');
  command->add_option("--report", options.report,
                      "Write each result at once into this .md or .json, with the earlier ones");
  command->add_option("--work", options.work, "Folder for the copy, its build and the logs [build/mutants]");
}

void add_starter(CLI::App& app, StarterOptions& options) {
  CLI::App* command = app.add_subcommand("starter", "Write the tree that students start with");
  command->footer(
      "Exit codes: 0 holds, 1 --verify found a fault, 2 wrong usage, 3 could not write, build or draw.");
  CLI::Option* out = command->add_option("--out", options.out, "A new folder");
  command->add_option("--root", options.root, "The course's tree [the source tree]");
  command->add_option("--solve", options.solve, "Steps that are already solved in it, as 5.1,5.2")
      ->delimiter(',');
  CLI::Option* verify =
      command
          ->add_flag(
              "--verify", options.verify,
              "Write nothing. Check that the starter fails every step, that with the first k steps solved\n"
              "exactly those pass, and that all pass in the end")
          ->excludes(out);
  command
      ->add_option(
          "--pictures", options.pictures,
          "Write only a folder of pictures: what each step looks like before and after, side by side")
      ->excludes(out)
      ->excludes(verify);
  command->add_option("--labs", options.labs, "With --verify or --pictures: numbers of labs, as 1,5 [all]")
      ->delimiter(',')
      ->check(CLI::Range(1, 99))
      ->excludes(out);
  command
      ->add_option("--cache", options.cache,
                   "With --verify or --pictures: folder for what is made on the way [build/grade]")
      ->excludes(out);
}

CLI::Option* add_context(CLI::App* command, std::string& context) {
  return command->add_option("--context", context, "Where OpenGL comes from")
      ->check(CLI::IsMember({"auto", "osmesa", "egl"}));
}

/// What the student's commands take.
struct StudentCommands {
  CheckOptions check;
  WatchOptions watch;
  HintOptions hint;
  std::string progress_context = "auto", reset;
};

void add_student(CLI::App& app, StudentCommands& all) {
  CLI::App* check =
      app.add_subcommand("check", "Show which steps are right, and how far the next one is off");
  check->footer("Exit codes: 0 all steps passed, 1 not all, 2 wrong usage, 3 could not draw or compare.");
  check->add_option("LAB", all.check.labs, "Numbers of labs [all]")->check(CLI::Range(1, 99));
  check->add_flag("--json", all.check.json, "Print JSON: an object for one lab, a list for several");
  check->add_flag("--unless-begun", all.check.unless_begun,
                  "Exit code 0 also if no step of these labs is begun");
  add_context(check, all.check.context);
  CLI::App* watch = app.add_subcommand("watch", "Check a lab after every save; h shows a hint, q quits");
  watch->add_option("LAB", all.watch.lab, "The lab's number")->required()->check(CLI::Range(1, 99));
  add_context(watch, all.watch.context);
  CLI::App* hint = app.add_subcommand("hint", "Show one more hint for a step");
  hint->add_option("STEP", all.hint.where, "A step as 5.1, or a lab's number [the next step of the course]");
  add_context(hint, all.hint.context);
  CLI::App* reset =
      app.add_subcommand("reset", "Restore a step's starting code; your code is saved in another file");
  reset->add_option("STEP", all.reset, "A step as 5.1")->required();
  CLI::App* progress = app.add_subcommand("progress", "Show all labs with their steps and points");
  add_context(progress, all.progress_context);
}

void add_expected(CLI::App& app, ExpectedCommand& command) {
  CLI::App* expected =
      app.add_subcommand("expected", "Draw the expected pictures of 'check' with the solutions");
  expected->add_option("LAB", command.labs, "Numbers of labs [all]")->check(CLI::Range(1, 99));
  expected->add_option("--cache", command.cache, "Folder for starter, references and programs [build/grade]");
}

void add_renderers(CLI::App& app, RenderersCommand& command) {
  CLI::App* renderers =
      app.add_subcommand("renderers", "Compare each case's limit with the spread between renderers");
  renderers->add_option("--out", command.out,
                        "Folder of the pictures, one for each renderer [out/renderers]");
  renderers->add_option("--only", command.only, "Names of renderers separated by commas [all]")
      ->delimiter(',');
  renderers->add_option("--json", command.json, "Write the figures as JSON, as in docs/renderers.json");
  renderers->add_option("--markdown", command.markdown,
                        "Write the table at the end of this file again, as in docs/accuracy.md");
  renderers->add_option("--reference", command.reference,
                        "Folder with which hidden cases are compared [mesa22_llvmpipe_osmesa]");
  renderers->footer(
      "Exit codes: 0 every limit is three times the spread, 1 one is not or a mutant passes, 2 wrong "
      "usage,\n3 could not draw.");
  renderers->add_flag("--judge-only", command.judge_only, "Draw nothing: judge the pictures that are there");
  renderers->add_flag("--mutants", command.mutants, "Check that mutants and starters fail on each renderer");
  renderers->add_option("--cache", command.cache,
                        "Folder for starter, references and programs [build/grade]");
}

/// What the four commands of grading take.
struct GradeCommands {
  GradeCommand grade;
  GradeMergeCommand merge;
  GradeOverrideCommand override_score;
  GradeReportCommand report;
};

void add_formats(CLI::App* command, std::vector<std::string>& formats) {
  command
      ->add_option("--format", formats,
                   "Also write results for other systems: gradescope, prairielearn, junit, csv")
      ->delimiter(',')
      ->check(CLI::IsMember({"gradescope", "prairielearn", "junit", "csv"}));
}

void add_grade(CLI::App& app, GradeCommands& all) {
  CLI::App* grade = app.add_subcommand("grade", "Grade a class from headless snapshots");
  grade->footer(
      "Exit codes: 0 graded, 2 wrong usage, 3 some students could not be graded (they get no zero: run again "
      "with\n"
      "--resume), or the grader itself failed.");
  GradeCommand& g = all.grade;
  grade->add_option("CLASS", g.class_folder, "Folder with one folder, .zip or .tar.gz per student");
  grade->add_option("--out", g.out, "Folder for results and reports [out/grades]");
  grade->add_option("--labs", g.labs, "Numbers of labs, as 1,5 [all]")
      ->delimiter(',')
      ->check(CLI::Range(1, 99));
  grade->add_option("--jobs", g.jobs, "Jobs at the same time [one per processor]")
      ->check(CLI::Range(1, 1024));
  grade->add_option("--shard", g.shard, "Grade one part of the class: 2/8 is the second of eight parts");
  grade->add_flag("--resume", g.resume,
                  "Continue an earlier run that was interrupted; nothing is judged twice");
  grade->add_option("--seed-file", g.seed_file,
                    "The course's secret seed for hidden cases [OUT/seed.txt, created if missing]");
  grade->add_option("--cache", g.cache, "Folder for starter, references and programs [build/grade]");
  add_context(grade, g.context);
  grade->add_flag("--unsafe", g.unsafe,
                  "Run the students' programs without a sandbox; only for code that you trust");
  add_formats(grade, g.formats);

  CLI::App* merge = grade->add_subcommand("merge", "Merge the results of shards");
  merge->add_option("PART", all.merge.parts, "Folders that 'texel grade --shard' wrote")->required();
  merge->add_option("--out", all.merge.out, "A folder for all of them")->required();
  add_formats(merge, all.merge.formats);

  CLI::App* change = grade->add_subcommand("override", "Set a step's score by hand; grading again keeps it");
  change->add_option("OUT", all.override_score.out, "Folder with the results")->required();
  change->add_option("STUDENT", all.override_score.student, "The student's id, as in the report")->required();
  change->add_option("STEP", all.override_score.step, "As 5.1")->required();
  CLI::Option* score =
      change->add_option("SCORE", all.override_score.score, "0 to 1")->check(CLI::Range(0.0, 1.0));
  change->add_option("--reason", all.override_score.reason, "Why; the report shows it to the student");
  change->add_flag("--drop", all.override_score.drop, "Remove an earlier override")->excludes(score);
  add_formats(change, all.override_score.formats);

  CLI::App* report = grade->add_subcommand("report", "Write the reports of earlier results again");
  report->add_option("OUT", all.report.out, "Folder with the results")->required();
  add_formats(report, all.report.formats);
}

Exit run_grade(const CLI::App& app, const GradeCommands& all) {
  const CLI::App* grade = app.get_subcommand("grade");
  if (grade->got_subcommand("merge")) return grade_merge(all.merge);
  if (grade->got_subcommand("override")) return grade_override(all.override_score);
  if (grade->got_subcommand("report")) return grade_report(all.report);
  if (all.grade.class_folder.empty())
    throw Error::usage("the class is missing; type texel grade CLASS --out DIR",
                       "CLASS is a folder with one folder or archive per student");
  return grade_class(all.grade);
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
  StarterOptions starter_options;
  GradeCommands grade_commands;
  StudentCommands student;
  ExpectedCommand expected_command;
  RenderersCommand renderers_command;
  bool list_only = false;
  app.add_subcommand("list", "List the labs");
  add_gallery(app, gallery_options, list_only);
  add_compare(app, compare_options);
  add_bench(app, bench_options);
  add_mutants(app, mutants_options);
  add_starter(app, starter_options);
  add_grade(app, grade_commands);
  add_student(app, student);
  add_expected(app, expected_command);
  add_renderers(app, renderers_command);
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
  if (app.got_subcommand("grade")) return run_grade(app, grade_commands);
  if (app.got_subcommand("starter")) return starter(starter_options);
  if (app.got_subcommand("check")) return check(student.check);
  if (app.got_subcommand("watch")) return watch(student.watch);
  if (app.got_subcommand("hint")) return hint(student.hint);
  if (app.got_subcommand("reset")) return reset(student.reset);
  if (app.got_subcommand("progress")) return progress(student.progress_context);
  if (app.got_subcommand("renderers")) return renderers(renderers_command);
  if (app.got_subcommand("expected")) return expected(expected_command);
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
