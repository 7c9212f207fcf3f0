// SPDX-License-Identifier: MIT
#include "grade/grader.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/process.hpp"
#include "core/stopwatch.hpp"
#include "judge/plan.hpp"
#include "measures.hpp"

namespace texel::bench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kStudents = 8;

void spoil(const fs::path& shader) {
  std::string text = read_file(shader);
  const std::string line = "fragment_texcoord = texcoord *";
  const std::size_t at = text.find(line);
  if (at == std::string::npos) throw Error::failed("hands no texture coordinate on", {shader.string()});
  write_file(shader, text.replace(at, line.size(), "fragment_texcoord = 1.3 * texcoord.ts *"));
}

/// All cases passed, or none did.
void check_grades(const grade::ClassResult& results, bool all_pass) {
  std::size_t cases = 0;
  for (const grade::StudentResult& student : results.students)
    for (const grade::LabResult& lab : student.labs)
      for (const grade::StepResult& step : lab.steps)
        for (const grade::CaseResult& one : step.cases) {
          ++cases;
          if (one.passed != all_pass)
            throw Error::failed(fmt::format("the case {} of {} is not what was to be graded: {}", one.name,
                                            student.id, one.message));
        }
  if (cases == 0 || results.students.size() != kStudents) throw Error::failed("nothing was graded");
}

/// `spoilt` is a shader that hands a texture coordinate on, and is to hand on another one.
void add_grading(const Options& options, Report& report, const std::string& what, int lab,
                 const std::string& spoilt, double target) {
  const fs::path students = options.work / "class", out = options.work / "grades",
                 seed = options.work / "seed";
  fs::remove_all(students);
  for (std::size_t i = 0; i < kStudents; ++i) {
    const fs::path tree = students / fmt::format("student_{}", i);
    for (const char* folder : {"common", "labs", "shaders"}) {
      fs::create_directories(tree);
      fs::copy(options.root / folder, tree / folder, fs::copy_options::recursive);
    }
    fs::create_directory_symlink(options.assets(), tree / "assets");
    if (!spoilt.empty()) spoil(tree / spoilt);
  }
  write_file(seed, "a seed of no course");
  const std::vector<course::Lab> all = course::read_labs(options.root / "labs");
  std::vector<course::Lab> chosen = all;
  std::erase_if(chosen, [&](const course::Lab& one) { return one.number != lab; });
  const std::vector<grade::LabPlan> plans =
      grade::plan(grade::with_needed(chosen, all), read_file(seed), options.work / "models");
  std::size_t cases = 0;
  for (const grade::LabPlan& plan : plans) {
    cases += kStudents * plan.cases.size();
    write_file(options.work / (plan.lab.folder + ".json"), plan.batch());
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
    in_parallel(processors(), kStudents * plans.size(), [&](std::size_t i) {
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
  check_grades(grade::read_results(out, options.root), spoilt.empty());
}

}  // namespace

void measure_grading(const Options& options, Report& report) {
  report.begin(
      "Grading beside drawing",
      fmt::format(
          "`texel grade` with its reports over a class of {} whose shaders are right, or make every picture "
          "another one; beside as many `--batch` that draw the same cases, one for each processor at a time. "
          "What a course does once (starter, references, the pictures of known mistakes) is done before.",
          kStudents));
  add_grading(options, report, "lab 1, all match", 1, "", 1.3);
  add_grading(options, report, "labs 8 and 9, all match", 9, "", 1.3);  // 9 needs steps of 8
  add_grading(options, report, "lab 1, all differ", 1, "shaders/01_texture_quad/texture_quad.vert", 2.2);
}

}  // namespace texel::bench
