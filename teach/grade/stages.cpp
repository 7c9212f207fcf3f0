// SPDX-License-Identifier: MIT
// The labs with only some of their steps solved, as students have them on the way.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "course/markers.hpp"
#include "grade/course_tree.hpp"
#include "grade/grader.hpp"
#include "grade/submission.hpp"
#include "workshop.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// The files, by path, in which a step is not solved.
std::map<std::string, std::string> unfinished_files(const fs::path& source, const Solved& solved) {
  std::map<std::string, std::string> files;
  for (const std::string& file : course::step_files(source)) {
    bool is_finished = true;
    std::string text = course::with_steps(read_file(source / file), file, [&](const std::string& step) {
      is_finished = is_finished && solved.contains(step);
      return solved.contains(step);
    });
    if (!is_finished) files.emplace(file, std::move(text));
  }
  return files;
}

Stage make_stage(Workshop& workshop, const course::Lab& lab, const Solved& solved, const fs::path& root) {
  const fs::path course = workshop.tree().source;
  const std::map<std::string, std::string> files = unfinished_files(course, solved);
  const Program program = workshop.make(lab.program(), files);
  if (!program.refused.empty())
    throw Error::failed("does not build with only some of the steps solved", {program.refused.front().file},
                        program.refused.front().text);
  make_root(course, files, root);
  return {program.file, root};
}

/// Writes what a student would hand in who has solved the steps of `solved` and no others.
void write_submission(const fs::path& course, const Solved& solved, const fs::path& to) {
  for (const std::string& file : course::step_files(course)) {
    fs::create_directories((to / file).parent_path());
    write_file(to / file, course::with_steps(read_file(course / file), file,
                                             [&](const std::string& step) { return solved.contains(step); }));
  }
}

/// The name of the submission in which the first k steps are solved; by name they are in order.
std::string stage_name(std::size_t k) {
  return fmt::format("stage-{:02}", k);
}

}  // namespace

std::map<Solved, Stage> make_stages(const CourseTree& tree, const course::Lab& lab,
                                    const std::vector<Solved>& stages, const fs::path& folder) {
  Workshop workshop(solution_tree(tree.course, tree.build, {}), tree.cache / "solutions", run_plainly);
  std::vector<Stage> made(stages.size());
  in_parallel(processors(), stages.size(), [&](std::size_t i) {
    made[i] = make_stage(workshop, lab, stages[i], folder / fmt::format("{}", i));
  });
  std::map<Solved, Stage> by_solved;
  for (std::size_t i = 0; i < stages.size(); ++i) by_solved[stages[i]] = made[i];
  return by_solved;
}

std::vector<std::string> verify_starter(const CourseTree& options,
                                        const std::function<void(const std::string&)>& say) {
  std::vector<std::string> faults;
  const std::vector<course::Lab> all = course::read_labs(options.course / "labs");
  for (const course::Lab& lab : options.labs) {
    const fs::path work = options.cache / "verify" / lab.folder;
    fs::remove_all(work);
    // Steps that the lab needs of others are solved.
    Solved solved;
    for (const course::Lab& other : all)
      for (const course::Step& step : other.steps)
        if (other.number != lab.number) solved.insert(step.id);
    for (std::size_t k = 0; k <= lab.steps.size(); ++k) {
      if (k > 0) solved.insert(lab.steps[k - 1].id);
      write_submission(options.course, solved, work / "class" / stage_name(k));
    }
    GradeOptions grading;
    grading.class_folder = work / "class", grading.out = work / "out";
    grading.course = options.course, grading.build = options.build, grading.cache = options.cache;
    grading.labs = {lab.number};
    grading.run = run_plainly;  // the course's own
    grade_class(grading, [&](const std::string& line) { say(fmt::format("lab {}: {}", lab.number, line)); });
    const store::ClassResult results = read_results(grading.out, options.course);
    for (std::size_t k = 0; k < results.students.size(); ++k) {
      const store::StudentResult& student = results.students[k];
      if (!student.incident.empty()) throw Error::failed(student.incident);
      std::vector<std::string> passed, expected;
      for (const judge::StepResult& step : student.labs.front().steps)
        if (step.status == judge::Status::passed) passed.push_back(step.id);
      for (std::size_t i = 0; i < k; ++i) expected.push_back(lab.steps[i].id);
      if (student.id != stage_name(k) || passed != expected)
        faults.push_back(fmt::format("lab {} with {} of {} steps solved passes [{}], not [{}]", lab.number, k,
                                     lab.steps.size(), fmt::join(passed, " "), fmt::join(expected, " ")));
    }
    fs::remove_all(work);
  }
  return faults;
}

}  // namespace texel::grade
