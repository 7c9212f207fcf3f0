// SPDX-License-Identifier: MIT
#include "grade/grader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/process.hpp"
#include "core/stopwatch.hpp"
#include "course/batch.hpp"
#include "course/markers.hpp"
#include "course/mutant_file.hpp"
#include "grade/hidden_cases.hpp"
#include "judge/plan.hpp"
#include "measures.hpp"

namespace texel::bench {
namespace {

namespace fs = std::filesystem;

/// What some students of a class wrote in place of the solution's text.
struct Mistake {
  std::size_t students = 0;
  std::string file, right, wrong;
};

/// Each student's text is another one.
void make(const Mistake& mistake, const fs::path& tree, std::size_t student) {
  const fs::path file = tree / mistake.file;
  std::string text = read_file(file);
  const std::size_t at = text.find(mistake.right);
  if (at == std::string::npos) throw Error::failed("there is no " + mistake.right, {file.string()});
  text.replace(at, mistake.right.size(), mistake.wrong);
  write_file(file, fmt::format("{}// student {}\n", text, student));
}

/// As many students lost points as made the mistake. Where all made it, none of their own pictures is right.
void check_grades(const grade::ClassResult& results, std::size_t students, std::size_t wrong) {
  std::size_t failed = 0, cases = 0, right = 0;
  for (const grade::StudentResult& student : results.students)
    for (const grade::LabResult& lab : student.labs)
      for (const grade::StepResult& step : lab.steps)
        for (const grade::CaseResult& one : step.cases) ++cases, right += one.passed() && !one.is_alone();
  if (cases == 0 || (wrong == 0 && right != cases) || (wrong == students && right != 0))
    throw Error::failed(fmt::format("{} of {} cases are right", right, cases));
  for (const grade::StudentResult& student : results.students)
    failed += std::any_of(student.labs.begin(), student.labs.end(), [](const grade::LabResult& lab) {
      return std::any_of(lab.steps.begin(), lab.steps.end(),
                         [](const grade::StepResult& step) { return step.status != grade::Status::passed; });
    });
  if (results.students.size() != students || failed != wrong)
    throw Error::failed(fmt::format("{} of {} students lost points, and {} of {} are to", failed,
                                    results.students.size(), wrong, students));
}

void add_grading(const Options& options, Report& report, const std::string& what, int lab, double target,
                 std::size_t size, const Mistake& mistake = {}) {
  const fs::path students = options.work / "class", out = options.work / "grades",
                 seed = options.work / "seed";
  fs::remove_all(students);
  for (std::size_t i = 0; i < size; ++i) {
    const fs::path tree = students / fmt::format("student_{}", i);
    for (const char* folder : {"common", "labs", "shaders"}) {
      fs::create_directories(tree);
      fs::copy(options.root / folder, tree / folder, fs::copy_options::recursive);
    }
    fs::create_directory_symlink(options.assets(), tree / "assets");
    if (i < mistake.students) make(mistake, tree, i);
  }
  write_file(seed, "a seed of no course");
  std::vector<course::Lab> chosen = course::read_labs(options.root / "labs");
  std::erase_if(chosen, [&](const course::Lab& one) { return one.number != lab; });
  const std::vector<grade::LabPlan> plans =
      grade::full_plan(chosen, read_file(seed), options.work / "models");
  std::size_t cases = 0;
  for (const grade::LabPlan& plan : plans) {
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
                   "TEXEL_ROOT=" + (students / student).string(), options.program(drawn.program()), "--batch",
                   options.work_file(drawn.folder + ".json"), "--out",
                   options.work_file("drawn/" + student)});
    });
    return stopwatch.milliseconds();
  };
  report.add(row_of(fmt::format("{}, {} cases", what, cases), "grade", "batches", "ms",
                    interleaved(options.long_rounds(), grade, draw), Target::at_most, target));
  check_grades(grade::read_results(out, options.root), size, mistake.students);
}

/// A class in labs of C++ and GLSL that made a mistake in every tenth step: judged with each step that fails
/// once more alone, beside judged without. All texts are new in each run, as a class's are: nothing is
/// compiled before.
void add_judged_alone(const Options& options, Report& report) {
  constexpr std::size_t students = 4, one_of = 10;
  const std::vector<int> numbers = {1, 5, 8};
  std::vector<course::Lab> labs = course::read_labs(options.root / "labs");
  std::erase_if(labs, [&](const course::Lab& lab) {
    return std::find(numbers.begin(), numbers.end(), lab.number) == numbers.end();
  });
  std::vector<std::string> steps;
  for (const course::Lab& lab : labs)
    for (const course::Step& step : lab.steps) steps.push_back(step.id);
  const std::vector<course::Mutant> mutants = course::read_catalogue(options.root / "tests/mutants");
  const std::vector<std::string> files = course::step_files(options.root);
  const fs::path folder = options.work / "tenth";
  const auto write_class = [&](int run) {
    fs::remove_all(folder);
    std::size_t mistakes = 0;
    for (std::size_t student = 0; student < students; ++student) {
      std::map<std::string, std::string> texts;
      for (const std::string& file : files) texts[file] = read_file(options.root / file);
      for (std::size_t i = 0; i < steps.size(); ++i) {
        if ((student * steps.size() + i) % one_of != 0) continue;
        const auto mutant = std::find_if(mutants.begin(), mutants.end(), [&](const course::Mutant& one) {
          return one.step == steps[i] && texts.contains(one.file);
        });
        if (mutant == mutants.end()) throw Error::failed("there is no mutant of step " + steps[i]);
        texts[mutant->file] = course::mutated(*mutant, texts[mutant->file]);
        ++mistakes;
      }
      for (const auto& [file, text] : texts) {
        const fs::path to = folder / fmt::format("student_{}", student) / file;
        fs::create_directories(to.parent_path());
        write_file(to, course::with_steps(text, file, [](const std::string&) { return true; }) +
                           fmt::format("// student {} of class {} in {}\n", student, run,
                                       options.work.filename().string()));
      }
    }
    return mistakes;
  };
  grade::GradeOptions grading;
  grading.class_folder = folder, grading.out = options.work / "tenth_grades";
  grading.course = options.root, grading.build = options.bin.parent_path();
  grading.cache = options.root / "build/grade", grading.seed_file = options.work / "seed";
  grading.labs = numbers;
  write_file(grading.seed_file, "a seed of no course");
  int run = 0;
  std::size_t mistakes = 0;
  const auto grade = [&](bool alone) {
    mistakes = write_class(++run);
    grading.judge_alone = alone;
    fs::remove_all(grading.out);
    return 1000 * grade::grade_class(grading, [](const std::string&) {}).seconds;
  };
  grade(true);  // the mutants' pictures are drawn once for a course
  report.add(
      row_of(fmt::format("labs 1, 5 and 8, {} mistakes in {} steps", mistakes, students * steps.size()),
             "failed steps once more alone", "judged once", "ms",
             interleaved(
                 options.long_rounds(), [&] { return grade(true); }, [&] { return grade(false); }),
             Target::at_most, 1.3));
}

}  // namespace

void measure_grading(const Options& options, Report& report) {
  report.begin(
      "Grading beside drawing",
      "`texel grade` with its reports over a class whose shaders are right, or some or all of them "
      "wrong; beside as many `--batch` that draw the same cases, one for each processor at a time. "
      "Each step that fails is drawn again, alone; the last row has that beside drawing once. What a "
      "course does once (starter, references, the pictures of known mistakes) is done before.");
  const Mistake turned{8, "shaders/01_texture_quad/texture_quad.vert", "fragment_texcoord = texcoord *",
                       "fragment_texcoord = 1.3 * texcoord.ts *"};
  const Mistake tilted{5, "shaders/05_normal_map/decode_normal.glsl", "return color * 2.0 - 1.0",
                       "return color * 2.0 - 0.9"};
  add_grading(options, report, "lab 1, 8 students, all right", 1, 1.3, 8);
  add_grading(options, report, "lab 9, 8 students, all right", 9, 1.3, 8);
  add_grading(options, report, "lab 1, 8 students, all wrong", 1, 2.2, 8, turned);
  add_grading(options, report, "lab 5, 12 students, 5 wrong in one step", 5, 1.5, 12, tilted);
  add_judged_alone(options, report);
}

}  // namespace texel::bench
