// SPDX-License-Identifier: MIT
#include "grade/grader.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "commands.hpp"
#include "course_commands.hpp"
#include "reports/reports.hpp"
#include "store/store.hpp"

namespace texel::commands {
namespace {

namespace fs = std::filesystem;

/// "3/8".
void read_shard(const std::string& text, grade::GradeOptions& options) {
  const int read = std::sscanf(text.c_str(), "%u/%u", &options.shard, &options.shards);
  if (read != 2 || fmt::format("{}/{}", options.shard, options.shards) != text)
    throw Error::usage(fmt::format("'{}' is not a shard", text), "write it as 1/4");
}

/// On a terminal each line replaces the one before; in a log it follows it. Uses standard error, because the
/// results go to standard output.
void say(const std::string& line) {
  static const bool is_terminal = ::isatty(STDERR_FILENO) != 0;
  std::fprintf(stderr, is_terminal ? "\r\033[K%s" : "%s\n", line.c_str());
  std::fflush(stderr);
}

void print_class(const store::ClassResult& results) {
  std::size_t width = 0;
  for (const store::StudentResult& student : results.students) width = std::max(width, student.id.size());
  for (const store::StudentResult& student : results.students) {
    const std::string unmarked = student.unmarked();
    fmt::print("{:<{}}  {:>6} of {:g}{}\n", student.id, width,
               unmarked.empty() ? fmt::format("{:.2f}", student.points()) : "-", student.max_points(),
               !unmarked.empty()       ? "  NOT GRADED IN FULL, grade again with --resume: " + unmarked
               : student.fault.empty() ? ""
                                       : "  " + student.fault);
  }
}

/// Where the results in a folder are. Throws Error (exit 3) if there are none.
fs::path existing_store(const fs::path& out) {
  if (!fs::exists(grade::store_file(out)))
    throw Error::failed("contains no results", {out.string()}, "name a folder that 'texel grade' wrote");
  return grade::store_file(out);
}

/// Every report of the results in a folder. Returns how many students are not graded in full.
std::size_t write_reports(const fs::path& out, const std::vector<std::string>& formats) {
  const store::ClassResult results = grade::read_results(out, tools::course_root());
  reports::write_html(results, out);
  for (const std::string& format : formats) reports::write_format(format, results, out);
  print_class(results);
  fmt::print("look at the page   file://{}\n",
             fs::absolute(out / "report/index.html").lexically_normal().string());
  return static_cast<std::size_t>(std::ranges::count_if(
      results.students, [](const auto& student) { return !student.unmarked().empty(); }));
}

}  // namespace

Exit grade_class(GradeCommand command) {
  const grade::CourseTree tree = course_tree({}, command.cache);
  command.course = tree.course, command.build = tree.build, command.cache = tree.cache;
  command.run = command.unsafe            ? run_plainly
                : command.walls == "user" ? sandbox::run_as_another_user
                                          : sandbox::run_locked_in;
  read_shard(command.part, command);
  const grade::GradeSummary summary = grade::grade_class(command, say);
  if (::isatty(STDERR_FILENO) != 0) std::fprintf(stderr, "\n");
  write_reports(command.out, command.formats);
  fmt::print("graded {} students: {} cases in {:.1f} s, {:.1f} cases a second\n", summary.students,
             summary.cases, summary.seconds,
             static_cast<double>(summary.cases) / std::max(summary.seconds, 1e-3));
  if (summary.incidents > 0)
    throw Error::failed(
        fmt::format("{} students could not be graded in full", summary.incidents), {},
        "it is not the students' fault: read the messages above, then run the same command with --resume");
  return Exit::holds;
}

Exit grade_report(const EarlierResults& results) {
  // Of a run that was cut off these are no marks to hand out.
  const std::size_t open = write_reports(results.out, results.formats);
  if (open > 0 && !results.unfinished)
    throw Error::failed(fmt::format("the run is not finished: {} students have no mark", open),
                        {results.out.string()},
                        "run texel grade again with --resume, or accept this with --unfinished");
  return Exit::holds;
}

Exit grade_merge(const EarlierResults& joined, const std::vector<fs::path>& parts) {
  std::error_code error;
  fs::create_directories(joined.out, error);
  store::Store store(grade::store_file(joined.out));
  for (const fs::path& part : parts) {
    store.merge(store::Store(existing_store(part)));
    for (const char* folder : {"pictures", "references"})
      if (fs::exists(part / folder))
        fs::copy(part / folder, joined.out / folder,
                 fs::copy_options::recursive | fs::copy_options::overwrite_existing);
  }
  return grade_report(joined);
}

Exit grade_override(const GradeOverrideCommand& command) {
  const fs::path file = existing_store(command.out);
  const store::ClassResult results = grade::read_results(command.out, tools::course_root());
  std::vector<std::string> students, steps;
  for (const store::StudentResult& student : results.students) {
    students.push_back(student.id);
    for (const judge::LabResult& lab : student.labs)
      for (const judge::StepResult& step : lab.steps) steps.push_back(step.id);
  }
  const auto check = [](const std::string& word, const std::vector<std::string>& known, const char* what) {
    if (std::ranges::count(known, word) > 0) return;
    throw Error::usage(fmt::format("there is no {} '{}'", what, word), did_you_mean(word, known));
  };
  check(command.student, students, "student");
  check(command.step, steps, "step");
  store::Store store(file);
  if (command.drop)
    store.drop_override(command.student, command.step);
  else
    store.put_override({command.student, command.step, command.score, command.reason});
  return grade_report(command);
}

}  // namespace texel::commands
