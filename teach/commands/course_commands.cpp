// SPDX-License-Identifier: MIT
#include "course_commands.hpp"

#include <fmt/format.h>

#include "command_line.hpp"

namespace texel::commands {
namespace {

/// What the four commands of grading take.
struct GradeCommands {
  GradeCommand grade;
  GradeMergeCommand merge;
  GradeOverrideCommand override_score;
  GradeReportCommand report;
};

/// Commands that are scripts: all that follows the name is theirs, --help too.
struct Script {
  const char *name, *file, *help;
};
constexpr Script kScripts[] = {
    {"bench", "bench.py", "Measure every method's error and cost, and plot one against the other"},
    {"marks", "marks.py", "Check that each mistake of the catalogue loses marks, and no right answer"},
    {"renderers", "renderers.py", "Compare each case's limit with the spread between renderers"}};

void add_scripts(CLI::App& app) {
  for (const Script& script : kScripts)
    app.add_subcommand(script.name, script.help)->prefix_command()->set_help_flag();
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

void add_expected(CLI::App& app, ExpectedCommand& command) {
  CLI::App* expected =
      app.add_subcommand("expected", "Draw the expected pictures of 'check' with the solutions");
  expected->add_option("LAB", command.labs, "Numbers of labs [all]")->check(CLI::Range(1, 99));
  expected->add_option("--cache", command.cache, "Folder for starter, references and programs [build/grade]");
}

void add_cases(CLI::App& app, CasesCommand& command) {
  CLI::App* cases = app.add_subcommand("cases", "What scripts ask of the grader");
  cases->add_option("WHAT", command.what)
      ->required()
      ->check(CLI::IsMember({"renderer", "draw", "batch", "mutants", "spreads", "marks"}));
  cases->add_option("--out", command.out,
                    "Folder for the pictures of draw and the lists of batch, else a file for JSON");
  cases->add_option("--seed", command.seed, "For batch: of the hidden cases");
  cases->add_option("--drawn", command.drawn, "For spreads: a folder with one of draw for each renderer");
  cases->add_option("--reference", command.reference, "The one of them that is right in hidden cases");
  cases->add_option("--labs", command.labs, "Numbers of labs, as 1,5 [all]")->delimiter(',');
  cases->add_option("--seeds", command.seeds, "For marks: with so many seeds of the hidden cases [3]");
  cases->add_flag("--places", command.places, "For marks: only what the starter has in each place");
  cases->add_option("--cache", command.cache, "Folder for starter, references and programs [build/grade]");
  tools::add_context(cases, command.context);
}

void add_formats(CLI::App* command, std::vector<std::string>& formats) {
  command
      ->add_option("--format", formats,
                   "Also write results for other systems: gradescope, prairielearn, junit, csv")
      ->delimiter(',')
      ->check(CLI::IsMember({"gradescope", "prairielearn", "junit", "csv"}));
}

void add_unfinished(CLI::App* command, bool& unfinished) {
  command->add_flag("--unfinished", unfinished,
                    "Exit with 0 even if the run was cut off and students have no mark yet");
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
  grade->add_flag("--judge-once", g.judge_once,
                  "Do not draw failed steps once more alone: to measure what that costs");
  grade->add_option("--shard", g.shard, "Grade one part of the class: 2/8 is the second of eight parts");
  grade->add_flag("--resume", g.resume,
                  "Continue an earlier run that was interrupted; nothing is judged twice");
  grade->add_option("--seed-file", g.seed_file,
                    "The course's secret seed for hidden cases [OUT/seed.txt, created if missing]");
  grade->add_option("--cache", g.cache, "Folder for starter, references and programs [build/grade]");
  tools::add_context(grade, g.context);
  grade->add_flag("--unsafe", g.unsafe,
                  "Run the students' programs without a sandbox; only for code that you trust");
  grade
      ->add_option("--walls", g.walls,
                   "What holds the students' programs: namespaces; or user, for one student, as root in a "
                   "container that forbids namespaces [namespaces]")
      ->check(CLI::IsMember({"namespaces", "user"}));
  add_formats(grade, g.formats);
  grade->add_flag("--print-steps", g.print_steps,
                  "Grade nothing: print as JSON the steps that each submission has, and what is not taken");

  CLI::App* merge = grade->add_subcommand("merge", "Merge the results of shards");
  merge->add_option("PART", all.merge.parts, "Folders that 'texel grade --shard' wrote")->required();
  merge->add_option("--out", all.merge.out, "A folder for all of them")->required();
  add_formats(merge, all.merge.formats);
  add_unfinished(merge, all.merge.unfinished);

  CLI::App* change = grade->add_subcommand("override", "Set a step's score by hand; grading again keeps it");
  change->add_option("OUT", all.override_score.out, "Folder with the results")->required();
  change->add_option("STUDENT", all.override_score.student, "The student's id, as in the report")->required();
  change->add_option("STEP", all.override_score.step, "As 5.1")->required();
  CLI::Option* score =
      change->add_option("SCORE", all.override_score.score, "0 to 1")->check(CLI::Range(0.0, 1.0));
  change->add_option("--reason", all.override_score.reason, "Why; the report shows it to the student");
  change->add_flag("--drop", all.override_score.drop, "Remove an earlier override")->excludes(score);
  add_formats(change, all.override_score.formats);
  add_unfinished(change, all.override_score.unfinished);

  CLI::App* report = grade->add_subcommand("report", "Write the reports of earlier results again");
  report->add_option("OUT", all.report.out, "Folder with the results")->required();
  add_formats(report, all.report.formats);
  add_unfinished(report, all.report.unfinished);
}

Exit run_grade(const CLI::App& app, const GradeCommands& all) {
  const CLI::App* grade = app.get_subcommand("grade");
  if (grade->got_subcommand("merge")) return grade_merge(all.merge);
  if (grade->got_subcommand("override")) return grade_override(all.override_score);
  if (grade->got_subcommand("report")) return grade_report(all.report);
  if (all.grade.class_folder.empty())
    throw Error::usage("the class is missing; type texel grade CLASS --out DIR",
                       "CLASS is a folder with one folder or archive per student");
  return all.grade.print_steps ? print_steps(all.grade) : grade_class(all.grade);
}

/// All of them.
class CourseCommands final : public tools::MoreCommands {
 public:
  explicit CourseCommands(CLI::App& app) : app_(app) {
    add_scripts(app);
    add_starter(app, starter_);
    add_grade(app, grade_);
    add_expected(app, expected_);
    add_cases(app, cases_);
    app.add_subcommand("course", "classroom, gradebook, gradescope, similar: see docs/course.md")
        ->prefix_command();
  }

  [[nodiscard]] std::optional<Exit> run() const override {
    for (const Script& script : kScripts)
      if (const CLI::App* command = app_.get_subcommand(script.name); command->parsed())
        return run_script(script.file, command->remaining());
    if (app_.got_subcommand("starter")) return starter(starter_);
    if (app_.got_subcommand("grade")) return run_grade(app_, grade_);
    if (app_.got_subcommand("expected")) return expected(expected_);
    if (app_.got_subcommand("cases")) return cases(cases_);
    if (const CLI::App* course = app_.get_subcommand("course"); course->parsed())
      return run_course_script(course->remaining());
    return {};
  }

 private:
  CLI::App& app_;
  StarterOptions starter_;
  GradeCommands grade_;
  ExpectedCommand expected_;
  CasesCommand cases_;
};

const bool known = [] {
  tools::MoreCommands::make = [](CLI::App& app) -> std::unique_ptr<tools::MoreCommands> {
    return std::make_unique<CourseCommands>(app);
  };
  return true;
}();

}  // namespace
}  // namespace texel::commands
