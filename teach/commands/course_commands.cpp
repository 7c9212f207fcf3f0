// SPDX-License-Identifier: MIT
#include "course_commands.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <set>

#include "core/files.hpp"
#include "core/terminal.hpp"
#include "course/batch.hpp"
#include "grade/hidden_cases.hpp"
#include "material/starter.hpp"

namespace texel::commands {

grade::CourseTree course_tree(const std::vector<int>& labs, const std::filesystem::path& cache) {
  const std::filesystem::path root = tools::course_root();
  return {root, tools::course_build(),
          cache.empty() ? root / "build/grade" : std::filesystem::absolute(cache), tools::chosen_labs(labs)};
}

namespace {

using Words = std::vector<std::string>;

/// Runs a script of teach/commands in place of this process, which the script finds in the variable TEXEL.
/// Returns only by an Error (exit 3), when it cannot be started.
Exit run_script(const std::filesystem::path& name, const Words& arguments) {
  const std::string script = (tools::course_root() / "teach/commands" / name).string();
  std::vector<char*> pointers = {const_cast<char*>(script.c_str())};
  for (const std::string& argument : arguments) pointers.push_back(const_cast<char*>(argument.c_str()));
  pointers.push_back(nullptr);
  std::error_code error;
  ::setenv("TEXEL", std::filesystem::read_symlink("/proc/self/exe", error).c_str(), 1);
  ::execv(script.c_str(), pointers.data());
  throw Error::failed(fmt::format("cannot be started: {}", std::strerror(errno)), {script});
}

/// `texel course NAME …`: one of teach/commands/scripts. Throws Error (exit 2) for a name that there is not.
Exit run_course_script(const Words& words) {
  const Words known = {"classroom", "gradebook", "gradescope", "similar"};
  const std::string name = words.empty() ? "" : words.front();
  if (std::ranges::count(known, name) == 0)
    throw Error::usage(fmt::format("there is no command 'course {}'", name),
                       fmt::format("the commands are {}", fmt::join(known, ", ")));
  return run_script(std::filesystem::path("scripts") / name, {words.begin() + 1, words.end()});
}

/// Commands that are scripts: all that follows the name is theirs, --help too.
struct Script {
  const char *name, *file, *help;
};
constexpr Script kScripts[] = {
    {"bench", "bench.py", "Measure every method's error and cost, and plot one against the other"},
    {"marks", "marks.py", "Check that each mistake of the catalogue loses marks, and no right answer"},
    {"renderers", "renderers.py", "Compare each case's limit with the spread between renderers"}};

CLI::App* add_compare(CLI::App& app, CompareOptions& options) {
  CLI::App* command = app.add_subcommand("compare", "Measure how far one picture is from another");
  command->footer("Exit codes: 0 holds, 1 differs, 2 wrong usage, 3 could not load, render or compare.");
  command->add_option("REF", options.reference, "The right picture: .png, .jpg, .gif, .bmp, .tga or .pfm")
      ->required();
  command->add_option("IMG", options.image, "The picture to compare with it, of the same size")->required();
  command->add_flag("--json", options.json, "Print one JSON object");
  command->add_option("--mask", options.mask, "Count only pixels where this picture is not black");
  command->add_option("--heatmap", options.heatmap, "Write a .png of where they differ");
  command->add_option("--max", options.max, "Limit of the largest difference over R, G and B");
  command->add_option("--mean", options.mean, "Limit of the mean over all samples");
  command->add_option("--p99", options.p99,
                      "Limit of the 99th percentile over the pixels' largest differences");
  command->add_option("--flip", options.flip, "Limit of the mean of FLIP, 0 to 1");
  return command;
}

/// A log shows each line at once.
void print_now(const std::string& line) {
  fmt::print("{}\n", line);
  flush_output();
}

struct StarterOptions {
  std::filesystem::path out;
  Words solve;                     ///< steps that are solved already
  std::filesystem::path pictures;  ///< write nothing else: a folder for a picture of each step
  bool verify = false;             ///< write nothing: check the starter
  std::vector<int> labs;           ///< of those; none for all
  std::filesystem::path cache;     ///< empty: build/grade of the course
};

CLI::App* add_starter(CLI::App& app, StarterOptions& options) {
  CLI::App* command = app.add_subcommand("starter", "Write the tree that students start with");
  command->footer(
      "Exit codes: 0 holds, 1 --verify found a fault, 2 wrong usage, 3 could not write, build or draw.");
  CLI::Option* out = command->add_option("--out", options.out, "A new folder");
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
  return command;
}

/// `texel starter`: writes the tree that students start with.
Exit starter(const StarterOptions& options) {
  if (options.verify) {
    Words words;
    for (const int lab : options.labs) words.push_back(fmt::format("{}", lab));
    if (!options.cache.empty()) words.insert(words.end(), {"--cache", options.cache.string()});
    return run_script("verify_starter.py", words);
  }
  if (!options.pictures.empty()) {
    grade::draw_step_pictures(course_tree(options.labs, options.cache), options.pictures, print_now);
    return Exit::holds;
  }
  if (options.out.empty())
    throw Error::usage("the folder is missing; type texel starter --out DIR", "DIR is a new folder");
  std::set<std::string> unknown(options.solve.begin(), options.solve.end());
  const std::set<std::string> solved = unknown;
  for (const course::Lab& lab : tools::course_labs())
    for (const course::Step& step : lab.steps) unknown.erase(step.id);
  if (!unknown.empty())
    throw Error::usage(fmt::format("there is no step '{}'", *unknown.begin()),
                       "labs/*/lab.toml lists the steps");
  const auto is_solved = [&](const std::string& step) { return solved.contains(step); };
  material::write_files(material::starter_files(tools::course_root(), is_solved), options.out);
  fmt::print("wrote {}; start there with: ./run\n", options.out.string());
  return Exit::holds;
}

void add_cache(CLI::App* command, std::filesystem::path& cache) {
  command->add_option("--cache", cache, "Folder for starter, references and programs [build/grade]");
}

CLI::App* add_expected(CLI::App& app, std::vector<int>& labs, std::filesystem::path& cache) {
  CLI::App* command =
      app.add_subcommand("expected", "Draw the expected pictures of 'check' with the solutions");
  command->add_option("LAB", labs, "Numbers of labs [all]")->check(CLI::Range(1, 99));
  add_cache(command, cache);
  return command;
}

struct CasesCommand {
  std::string what;                  ///< renderer, draw, batch, mutants, spreads or marks
  std::filesystem::path out, drawn;  ///< a folder or a file for JSON; the renderers' folders
  std::filesystem::path catalogue;   ///< of other mutants than the course's, for marks
  std::string context = "auto", reference, seed;
  std::vector<int> labs;  ///< numbers; none for all
  int seeds = 3;          ///< of the hidden cases, for marks
  bool places = false;    ///< marks without the catalogue: only the steps' places as the starter has them
  std::filesystem::path cache;  ///< empty: build/grade of the course
};

CLI::App* add_cases(CLI::App& app, CasesCommand& command) {
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
  cases->add_option("--catalogue", command.catalogue, "For marks: only the mutants in this folder");
  add_cache(cases, command.cache);
  tools::add_context(cases, command.context);
  return cases;
}

/// `texel cases WHAT`: what the scripts of this folder ask of the grader, for ./run expected, renderers,
/// marks and performance.
Exit cases(const CasesCommand& command) {
  const grade::CourseTree tree = course_tree(command.labs, command.cache);
  if (command.what == "renderer") {
    fmt::print("{}\n", grade::renderer_here(tree, command.context));
  } else if (command.what == "draw") {
    grade::draw_cases(tree, command.context, std::filesystem::absolute(command.out));
  } else if (command.what == "batch") {
    make_folder(command.out);
    for (const course::Lab& plan : grade::full_plan(tree.labs, command.seed, command.out / "models"))
      write_file(command.out / (plan.folder + ".json"), course::to_batch(plan.cases));
  } else if (command.what == "mutants") {
    write_file(command.out, to_text(grade::wrongly_passed(tree, command.context, print_now)));
  } else if (command.what == "spreads") {
    write_file(command.out,
               to_text(grade::spreads(tree, std::filesystem::absolute(command.drawn), command.reference)));
  } else {
    write_file(command.out, to_text(grade::judged_solutions(tree, command.seeds, command.catalogue,
                                                            command.places, print_now)));
  }
  return Exit::holds;
}

void add_formats(CLI::App* command, std::vector<std::string>& formats) {
  command
      ->add_option("--format", formats,
                   "Also write results for other systems: gradescope, prairielearn, junit, csv")
      ->delimiter(',')
      ->check(CLI::IsMember({"gradescope", "prairielearn", "junit", "csv"}));
}

/// What makes new reports of earlier results.
CLI::App* add_reporting(CLI::App* grade, const char* name, const char* help, EarlierResults& results) {
  CLI::App* command = grade->add_subcommand(name, help);
  add_formats(command, results.formats);
  command->add_flag("--unfinished", results.unfinished,
                    "Exit with 0 even if the run was cut off and students have no mark yet");
  return command;
}

CLI::App* add_grade(CLI::App& app, GradeCommand& g) {
  CLI::App* grade = app.add_subcommand("grade", "Grade a class from headless snapshots");
  grade->footer(
      "Exit codes: 0 graded, 2 wrong usage, 3 some students could not be graded (they get no zero: run again "
      "with\n"
      "--resume), or the grader itself failed.");
  grade->add_option("CLASS", g.class_folder, "Folder with one folder, .zip or .tar.gz per student");
  g.out = "out/grades";
  grade->add_option("--out", g.out, "Folder for results and reports [out/grades]");
  grade->add_option("--labs", g.labs, "Numbers of labs, as 1,5 [all]")
      ->delimiter(',')
      ->check(CLI::Range(1, 99));
  grade->add_option("--jobs", g.jobs, "Jobs at the same time [one per processor]")
      ->check(CLI::Range(1, 1024));
  grade->add_flag_callback(
      "--judge-once", [&] { g.judge_alone = false; },
      "Do not draw failed steps once more alone: to measure what that costs");
  grade->add_option("--shard", g.part, "Grade one part of the class: 2/8 is the second of eight parts");
  grade->add_flag("--resume", g.resume,
                  "Continue an earlier run that was interrupted; nothing is judged twice");
  grade->add_option("--seed-file", g.seed_file,
                    "The course's secret seed for hidden cases [OUT/seed.txt, created if missing]");
  add_cache(grade, g.cache);
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

  return grade;
}

CLI::App* add_merge(CLI::App* grade, EarlierResults& joined, std::vector<std::filesystem::path>& parts) {
  CLI::App* command = add_reporting(grade, "merge", "Merge the results of shards", joined);
  command->add_option("PART", parts, "Folders that 'texel grade --shard' wrote")->required();
  command->add_option("--out", joined.out, "A folder for all of them")->required();
  return command;
}

CLI::App* add_override(CLI::App* grade, GradeOverrideCommand& options) {
  CLI::App* command =
      add_reporting(grade, "override", "Set a step's score by hand; grading again keeps it", options);
  command->add_option("OUT", options.out, "Folder with the results")->required();
  command->add_option("STUDENT", options.student, "The student's id, as in the report")->required();
  command->add_option("STEP", options.step, "As 5.1")->required();
  CLI::Option* score = command->add_option("SCORE", options.score, "0 to 1")->check(CLI::Range(0.0, 1.0));
  command->add_option("--reason", options.reason, "Why; the report shows it to the student");
  command->add_flag("--drop", options.drop, "Remove an earlier override")->excludes(score);
  return command;
}

CLI::App* add_report(CLI::App* grade, EarlierResults& results) {
  CLI::App* command = add_reporting(grade, "report", "Write the reports of earlier results again", results);
  command->add_option("OUT", results.out, "Folder with the results")->required();
  return command;
}

Exit run_grade(const GradeCommand& command) {
  if (command.class_folder.empty())
    throw Error::usage("the class is missing; type texel grade CLASS --out DIR",
                       "CLASS is a folder with one folder or archive per student");
  return command.print_steps ? print_steps(command) : grade_class(command);
}

/// All of them.
class CourseCommands final : public tools::MoreCommands {
 public:
  explicit CourseCommands(CLI::App& app) {
    for (const Script& script : kScripts) {
      CLI::App* command = app.add_subcommand(script.name, script.help)->prefix_command();
      command->set_help_flag();
      add(command, [=] { return run_script(script.file, command->remaining()); });
    }
    add(add_compare(app, compare_), [&] { return compare(compare_); });
    add(add_starter(app, starter_), [&] { return starter(starter_); });
    CLI::App* grade = add_grade(app, grade_);
    add(add_merge(grade, results_, parts_), [&] { return grade_merge(results_, parts_); });
    add(add_override(grade, override_), [&] { return grade_override(override_); });
    add(add_report(grade, results_), [&] { return grade_report(results_); });
    add(grade, [&] { return run_grade(grade_); });
    add(add_expected(app, labs_, cache_), [&] {
      grade::write_expected(course_tree(labs_, cache_), print_now);
      return Exit::holds;
    });
    add(add_cases(app, cases_), [&] { return cases(cases_); });
    CLI::App* course =
        app.add_subcommand("course", "classroom, gradebook, gradescope, similar: see docs/course.md")
            ->prefix_command();
    add(course, [=] { return run_course_script(course->remaining()); });
  }

  [[nodiscard]] std::optional<Exit> run() const override {
    for (const auto& [command, run] : commands_)
      if (command->parsed()) return run();
    return {};
  }

 private:
  void add(const CLI::App* command, std::function<Exit()> run) {
    commands_.emplace_back(command, std::move(run));
  }

  std::vector<std::pair<const CLI::App*, std::function<Exit()>>>
      commands_;  ///< what is part of one, before it
  CompareOptions compare_;
  StarterOptions starter_;
  GradeCommand grade_;
  EarlierResults results_;
  GradeOverrideCommand override_;
  CasesCommand cases_;
  std::vector<std::filesystem::path> parts_;
  std::vector<int> labs_;
  std::filesystem::path cache_;
};

const bool known = [] {
  tools::MoreCommands::make = [](CLI::App& app) -> std::unique_ptr<tools::MoreCommands> {
    return std::make_unique<CourseCommands>(app);
  };
  return true;
}();

}  // namespace
}  // namespace texel::commands
