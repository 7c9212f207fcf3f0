// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "core/error.hpp"
#include "core/files.hpp"
#include "course/markers.hpp"
#include "grade/course_tree.hpp"
#include "grade/grader.hpp"
#include "grade/submission.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// Writes what a student would hand in who has solved the steps of `solved` and no others.
void write_submission(const fs::path& course, const std::set<std::string>& solved, const fs::path& to) {
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

std::vector<std::string> verify_starter(const CourseTree& options,
                                        const std::function<void(const std::string&)>& say) {
  std::vector<std::string> faults;
  const std::vector<course::Lab> all = course::read_labs(options.course / "labs");
  for (const course::Lab& lab : options.labs) {
    const fs::path work = options.cache / "verify" / lab.folder;
    fs::remove_all(work);
    // Steps that the lab needs of others are solved.
    std::set<std::string> solved;
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
    if (results.students.size() != lab.steps.size() + 1)
      faults.push_back(fmt::format("lab {}: {} stages were graded, not {}", lab.number,
                                   results.students.size(), lab.steps.size() + 1));
    fs::remove_all(work);
  }
  return faults;
}

}  // namespace texel::grade
