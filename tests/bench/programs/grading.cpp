// SPDX-License-Identifier: MIT
#include "grade/grader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/process.hpp"
#include "core/stopwatch.hpp"
#include "course/batch.hpp"
#include "course/markers.hpp"
#include "grade/hidden_cases.hpp"
#include "judge/plan.hpp"
#include "material/mutant_file.hpp"
#include "measures.hpp"

namespace texel::bench {
namespace {

namespace fs = std::filesystem;

/// What a student makes of the text of one of the solution's files.
using Change = std::function<std::string(std::size_t student, const std::string& file, std::string text)>;

/// A student's files with steps. A comment in each of those with `ending` makes them new to the grader.
void hand_in(const fs::path& root, const fs::path& folder, std::size_t student, const Change& change,
             const std::string& ending, const std::string& comment) {
  for (const std::string& file : course::step_files(root)) {
    const std::string text = course::with_steps(change(student, file, read_file(root / file)), file,
                                                [](const std::string&) { return true; });
    fs::create_directories((folder / file).parent_path());
    write_file(folder / file, file.ends_with(ending) ? fmt::format("{}// {}\n", text, comment) : text);
  }
}

/// As many students lost points as made the mistake. Where all made it, none of their own pictures is right.
void check_grades(const store::ClassResult& results, std::size_t students, std::size_t wrong) {
  std::size_t failed = 0, cases = 0, right = 0;
  for (const store::StudentResult& student : results.students)
    for (const judge::LabResult& lab : student.labs)
      for (const judge::StepResult& step : lab.steps)
        for (const judge::CaseResult& one : step.cases) ++cases, right += one.passed() && !one.is_alone();
  if (cases == 0 || (wrong == 0 && right != cases) || (wrong == students && right != 0))
    throw Error::failed(fmt::format("{} of {} cases are right", right, cases));
  for (const store::StudentResult& student : results.students)
    failed += std::any_of(student.labs.begin(), student.labs.end(), [](const judge::LabResult& lab) {
      return std::any_of(lab.steps.begin(), lab.steps.end(),
                         [](const judge::StepResult& step) { return step.status != judge::Status::passed; });
    });
  if (results.students.size() != students || failed != wrong)
    throw Error::failed(fmt::format("{} of {} students lost points, and {} of {} are to", failed,
                                    results.students.size(), wrong, students));
}

/// A class of `size` students, of which the first `wrong` made a change each.
void add_grading(const Options& options, Report& report, const std::string& what, int lab, double target,
                 std::size_t size, std::size_t wrong = 0, const Change& change = {}) {
  const fs::path students = options.work / "class", out = options.work / "grades",
                 seed = options.work / "seed";
  fs::remove_all(students);
  for (std::size_t i = 0; i < size; ++i) {
    const fs::path tree = students / fmt::format("student_{}", i);
    fs::create_directories(tree);
    fs::copy(options.root / "shaders", tree / "shaders", fs::copy_options::recursive);
    const Change none = [](std::size_t, const std::string&, std::string text) { return text; };
    hand_in(options.root, tree, i, i < wrong ? change : none, ".glsl", fmt::format("student {}", i));
    fs::create_directory_symlink(options.assets(), tree / "assets");
  }
  write_file(seed, "a seed of no course");
  std::vector<course::Lab> chosen = course::read_labs(options.root / "labs");
  std::erase_if(chosen, [&](const course::Lab& one) { return one.number != lab; });
  const std::vector<judge::LabPlan> plans =
      grade::full_plan(chosen, read_file(seed), options.work / "models");
  std::size_t cases = 0;
  for (const judge::LabPlan& plan : plans) {
    cases += size * plan.cases.size();
    write_file(options.work / (plan.lab.folder + ".json"), course::to_batch(plan.cases));
  }
  const auto grade = [&] {
    const Stopwatch stopwatch;
    const Ran ran = run_program({options.program("texel"), "grade", students.string(), "--out", out.string(),
                                 "--labs", fmt::format("{}", lab), "--seed-file", seed.string()},
                                true);
    if (ran.exit_code != 0) throw Error::failed("the class is not graded: " + ran.output);
    return stopwatch.milliseconds();
  };
  const auto draw = [&] {
    const Stopwatch stopwatch;
    in_parallel(processors(), size * plans.size(), [&](std::size_t i) {
      const course::Lab& drawn = plans[i % plans.size()].lab;
      const std::string student = fmt::format("student_{}", i / plans.size());
      run_process({"env", "LP_NUM_THREADS=0", "TEXEL_THREADS=1",
                   "TEXEL_ROOT=" + (students / student).string(), options.program(drawn.program()),
                   "--samples", "1", "--batch", options.work_file(drawn.folder + ".json"), "--out",
                   options.work_file("drawn/" + student)});
    });
    return stopwatch.milliseconds();
  };
  report.add(row_of(fmt::format("{}, {} cases", what, cases), "grade", "batches", "ms",
                    interleaved(options.long_rounds(), grade, draw), Target::at_most, target));
  check_grades(grade::read_results(out, options.root), size, wrong);
}

/// The first of the catalogue in a step.
const material::Mutant& mutant_of(const std::vector<material::Mutant>& mutants, const std::string& step) {
  const auto found = std::find_if(mutants.begin(), mutants.end(),
                                  [&](const material::Mutant& one) { return one.step == step; });
  if (found == mutants.end()) throw Error::failed("there is no mutant of step " + step);
  return *found;
}

/// A class that made a mistake in every tenth step of some labs. All texts are new in each run, as a class's
/// are: nothing is compiled before.
class TenthOfStepsWrong {
 public:
  TenthOfStepsWrong(const Options& options, std::vector<int> labs, std::size_t students)
      : options_(options), students_(students), mistakes_(material::read_mistakes(options.root)) {
    for (const course::Lab& lab : course::read_labs(options.root / "labs"))
      if (std::find(labs.begin(), labs.end(), lab.number) != labs.end())
        for (const course::Step& step : lab.steps) steps_.push_back(step.id);
    grading_.class_folder = options.work / "tenth", grading_.out = options.work / "tenth_grades";
    grading_.course = options.root, grading_.build = options.bin.parent_path();
    grading_.cache = options.work / fmt::format("tenth_cache_{}", labs.size()),
    grading_.seed_file = options.work / "seed";
    grading_.labs = std::move(labs);
    write_file(grading_.seed_file, "a seed of no course");
  }

  /// Milliseconds of a run with its reports. The first one makes what a course does once.
  double grade(bool alone = true) {
    write_class();
    fs::remove_all(grading_.out);
    grading_.judge_alone = alone;
    const Stopwatch stopwatch;
    grade::grade_class(grading_, [](const std::string&) {});
    return stopwatch.milliseconds();
  }

  [[nodiscard]] std::string text() const {
    return fmt::format("{} students, {} mistakes in {} steps", students_, made_, students_ * steps_.size());
  }

 private:
  void write_class() {
    fs::remove_all(grading_.class_folder);
    made_ = 0, ++run_;
    const Change mistaken = [&](std::size_t student, const std::string& file, std::string text) {
      for (std::size_t i = 0; i < steps_.size(); ++i) {
        if ((student * steps_.size() + i) % kOneOf != 0) continue;
        const material::Mutant& mistake = mutant_of(mistakes_, steps_[i]);
        if (mistake.file != file) continue;
        text = material::mutated(mistake, text);
        ++made_;
      }
      return text;
    };
    for (std::size_t student = 0; student < students_; ++student)
      hand_in(options_.root, grading_.class_folder / fmt::format("student_{}", student), student, mistaken,
              "",
              fmt::format("student {} of class {} in {}", student, run_, options_.work.filename().string()));
  }

  static constexpr std::size_t kOneOf = 10;
  const Options& options_;
  std::size_t students_, made_ = 0;
  int run_ = 0;
  std::vector<material::Mutant> mistakes_;
  std::vector<std::string> steps_;
  grade::GradeOptions grading_;
};

/// Judged with each step that fails once more alone, beside judged without.
void add_judged_alone(const Options& options, Report& report) {
  TenthOfStepsWrong made(options, {1, 5, 8}, 4);
  made.grade();
  const std::vector<Pair> pairs = interleaved(
      options.long_rounds(), [&] { return made.grade(true); }, [&] { return made.grade(false); });
  report.add(row_of("labs 1, 5 and 8, " + made.text(), "failed steps once more alone", "judged once", "ms",
                    pairs, Target::at_most, 1.3));
}

/// What a large class takes, from a small one. Students are graded apart, so twice as many take twice as
/// long.
void add_course(const Options& options, Report& report) {
  constexpr std::size_t students = 6;
  constexpr double of_class = 1000, machines = 16, ms_per_hour = 3600e3;
  TenthOfStepsWrong made(options, {1, 2, 3, 4, 5, 6, 7, 8, 9}, students);
  const double first = made.grade(), again = made.grade();
  const double once = std::max(0.0, first - again), hours = again / students * of_class / ms_per_hour;
  report.note(fmt::format(
      "**{:.0f} students of nine labs**: {}, all C++ new, took {:.0f} s on {} processors: {:.0f} s a "
      "student. So "
      "{:.0f} students take {:.1f} hours on this machine, and {:.0f} minutes on {:.0f} such machines "
      "(`--shard`), which share nothing while they grade. What a course does once took {:.0f} s; it takes "
      "longer where the compiler's cache does not have the starter.",
      of_class, made.text(), again / 1000, processors(), again / 1000 / students, of_class, hours,
      (hours * ms_per_hour / machines + once) / 60e3, machines, once / 1000));
}

}  // namespace

void measure_grading(const Options& options, Report& report) {
  report.begin(
      "Grading beside drawing",
      "`texel grade` with its reports over a class whose shaders are right, or some or all of them "
      "wrong; beside as many `--batch` that draw the same cases, one for each processor at a time. "
      "Each step that fails is drawn again, alone, unless it has the solution's code; the last row has that "
      "beside drawing once. What a "
      "course does once (starter, references, the pictures of known mistakes) is done before. "
      "Before `grade` compared known mistakes by their samples, the class of lab 5 took 1.49 and 1.51 times "
      "as "
      "long.");
  const Change turned = [](std::size_t, const std::string& file, std::string text) {
    const std::string right = "fragment_texcoord = texcoord *";
    if (!file.ends_with("texture_quad.vert")) return text;
    return text.replace(text.find(right), right.size(), "fragment_texcoord = 1.3 * texcoord.ts *");
  };
  std::vector<material::Mutant> of_lab5;
  for (const material::Mutant& mutant : material::read_catalogue(options.root / "tests/mutants"))
    if (mutant.step.starts_with("5.") && mutant.file.ends_with(".glsl") && mutant.same.empty())
      of_lab5.push_back(mutant);
  const Change one_each = [&](std::size_t student, const std::string& file, std::string text) {
    const material::Mutant& mutant = of_lab5[student % of_lab5.size()];
    return mutant.file == file ? material::mutated(mutant, text) : text;
  };
  add_grading(options, report, "lab 1, 8 students, all right", 1, 1.3, 8);
  add_grading(options, report, "lab 9, 8 students, all right", 9, 1.3, 8);
  add_grading(options, report, "lab 1, 8 students, all wrong", 1, 2.2, 8, 8, turned);
  add_grading(options, report, "lab 5, 24 students, 10 with a mistake each", 5, 1.5, 24, 10, one_each);
  add_judged_alone(options, report);
  add_course(options, report);
}

}  // namespace texel::bench
