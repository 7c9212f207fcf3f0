// SPDX-License-Identifier: MIT
#include "grade/grader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <mutex>

#include "access.hpp"
#include "cache.hpp"
#include "class_setup.hpp"
#include "core/error.hpp"
#include "core/file_lock.hpp"
#include "core/parallel.hpp"
#include "core/stopwatch.hpp"
#include "course/markers.hpp"
#include "record.hpp"
#include "sandbox/sandbox.hpp"
#include "student_run.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// The students of this shard, by id.
std::vector<Entry> chosen_entries(const GradeOptions& options) {
  std::vector<Entry> entries = read_class(options.class_folder), chosen;
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.id < b.id; });
  for (std::size_t i = 0; i < entries.size(); ++i)
    if (i % options.shards == options.shard - 1) chosen.push_back(entries[i]);
  return chosen;
}

void make_folders(const GradeOptions& options) {
  for (const fs::path& folder : {options.out, options.out / "pictures", options.cache}) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
      throw Error::failed(fmt::format("cannot make the folder: {}", error.message()), {folder.string()},
                          "name a writable folder");
  }
}

/// What an exception says that nobody expected, from a full disk to a mistake of ours.
std::string incident_of(const std::exception& exception) {
  if (const auto* error = dynamic_cast<const fs::filesystem_error*>(&exception))
    return fmt::format("{}: {}", error->path1().string(), error->code().message());
  return exception.what();
}

/// A student whose labs are being graded. Opened by the first thread that comes, gone with the last.
class Student {
 public:
  Student(const ClassSetup& setup, const GradeOptions& options, Record& record, Entry entry)
      : setup_(setup), options_(options), record_(record), entry_(std::move(entry)) {}

  /// Whatever happens in one lab is an incident of that lab, and never the end of the class's run.
  void grade(const judge::LabPlan& plan) {
    std::call_once(once_, [&] { open(); });
    std::vector<course::Case> cases;
    for (const course::Case& one : plan.cases)
      if (!done_.contains(plan.lab.folder + "/" + one.name)) cases.push_back(one);
    JudgedLab judged;
    std::string incident = incident_;
    constexpr int tries = 2;
    for (int i = 0; i < tries && run_ && !cases.empty() && (i == 0 || !incident.empty()); ++i) try {
        incident.clear();
        judged = run_->judge(plan, cases, [&](const JudgedCase& one) { record_.keep(entry_, one); });
      } catch (const std::exception& exception) {
        incident = incident_of(exception);
      }
    record_.end_lab(entry_, plan, judged, plan.cases.size() - cases.size(), incident);
  }

 private:
  void open() {
    try {
      run_ = std::make_unique<StudentRun>(setup_, options_, entry_, options_.out / "work" / entry_.id);
      done_ = record_.begin(entry_, run_.get());
    } catch (const std::exception& exception) {
      incident_ = incident_of(exception);
      run_.reset();
      record_.begin(entry_, nullptr);
    }
  }

  const ClassSetup& setup_;
  const GradeOptions& options_;
  Record& record_;
  Entry entry_;
  std::once_flag once_;
  std::unique_ptr<StudentRun> run_;
  std::set<std::string> done_;  ///< cases that were judged before
  std::string incident_;        ///< why the submission could not be opened
};

/// The students one after the other, each one's labs side by side: all processors are busy to the end, and
/// only few submissions are open at a time.
void grade_students(const GradeOptions& options, const ClassSetup& setup, Record& record,
                    const std::vector<Entry>& entries, unsigned jobs) {
  const std::size_t labs = setup.plans.size();
  struct Open {
    std::unique_ptr<Student> student;
    std::size_t left;
  };
  std::mutex mutex;
  std::map<std::size_t, Open> open;
  in_parallel(jobs, entries.size() * labs, [&](std::size_t i) {
    const std::size_t index = i / labs;
    Student* student = nullptr;
    {
      const std::scoped_lock lock(mutex);
      Open& slot = open[index];
      if (!slot.student) slot = {std::make_unique<Student>(setup, options, record, entries[index]), labs};
      student = slot.student.get();
    }
    student->grade(setup.plans[i % labs]);
    std::unique_ptr<Student> done;  // its files are removed outside the lock
    const std::scoped_lock lock(mutex);
    if (--open[index].left > 0) return;
    done = std::move(open[index].student);
    open.erase(index);
  });
}

}  // namespace

fs::path store_file(const fs::path& folder) {
  return folder / "results.sqlite";
}

GradeSummary grade_class(const GradeOptions& given, const std::function<void(const std::string&)>& say) {
  GradeOptions options = given;
  for (fs::path* path :
       {&options.class_folder, &options.out, &options.course, &options.build, &options.cache})
    *path = fs::absolute(*path).lexically_normal();
  for (fs::path* path : {&options.out, &options.cache})
    if (!path->has_filename()) *path = path->parent_path();

  if (options.shard < 1 || options.shard > options.shards)
    throw Error::usage(fmt::format("there is no shard {} of {}", options.shard, options.shards),
                       "shards are 1/4, 2/4, …");
  if (options.run == sandbox::run_locked_in && !sandbox::sandbox_fault().empty())
    throw Error::failed("the sandbox for the students' programs does not work: " + sandbox::sandbox_fault());
  const bool as_another_user = options.run == sandbox::run_as_another_user;
  if (as_another_user && !sandbox::another_user_fault().empty())
    throw Error::failed("a program cannot be run as another user: " + sandbox::another_user_fault());
  const std::vector<Entry> entries = chosen_entries(options);
  if (as_another_user && entries.size() > 1)
    throw Error::usage(fmt::format("these walls hold for one student, and here are {}", entries.size()),
                       "programs of one could leave files for the next; grade on a machine with namespaces");
  make_folders(options);
  const FileLock lock(options.out / "lock", true);
  // Two programs at a time could read each other's files.
  const unsigned jobs = as_another_user ? 1 : options.jobs > 0 ? options.jobs : processors();
  if (as_another_user) restrict_access(options);

  const Stopwatch stopwatch;
  if (options.run == sandbox::run_locked_in && !sandbox::memory_group_fault().empty())
    say("the kernel does not count the sandboxes' memory: " + sandbox::memory_group_fault());
  say("preparing: starter, solution and references");
  const ClassSetup setup = prepare(options, jobs);
  say(fmt::format("ready after {}", duration_text(stopwatch.milliseconds() / 1000)));
  std::size_t cases = 0;
  for (const judge::LabPlan& plan : setup.plans) cases += plan.cases.size() * entries.size();
  Record record(options, setup, cases, say);
  record.expect(entries);
  fs::remove_all(options.out / "work");
  if (as_another_user) check_access(options);
  grade_students(options, setup, record, entries, jobs);
  fs::remove_all(options.out / "work");
  remove_unused(options.cache);
  return {entries.size(), record.judged(), record.incidents(), record.seconds()};
}

namespace {

/// Counts a student's cases, and takes the marks from steps whose cases are not all judged.
void count_cases(store::StudentResult& student) {
  for (judge::LabResult& lab : student.labs)
    for (judge::StepResult& step : lab.steps) {
      const auto planned = static_cast<std::size_t>(
          std::count_if(lab.lab.cases.begin(), lab.lab.cases.end(),
                        [&](const course::GradedCase& one) { return one.step == step.id; }));
      student.planned += planned;
      student.judged += std::min(step.cases.size(), planned);
      if (step.cases.size() >= planned || !step.overridden.empty()) continue;
      step.cases.clear();
      step.status = judge::Status::failed, step.score = 0;
      step.message = "This step is not judged yet.", step.mistake = step.mistake_says = "";
    }
}

}  // namespace

store::ClassResult read_results(const fs::path& folder, const fs::path& course) {
  if (!fs::exists(store_file(folder)))
    throw Error::failed("contains no results", {folder.string()}, "name the folder that was given to --out");
  const store::Store store(store_file(folder));
  store::ClassResult results = store.read(course::read_labs(course / "labs"));
  const std::string chosen = " " + results.facts["labs"] + " ";
  const std::map<std::string, Place> places = course::first_places(course);
  for (store::StudentResult& student : results.students) {
    // Others were graded only for what theirs need.
    std::erase_if(student.labs, [&](const judge::LabResult& lab) {
      return chosen.find(fmt::format(" {} ", lab.lab.number)) == std::string::npos;
    });
    count_cases(student);
    judge::put_places(student.labs, places);
  }
  return results;
}

}  // namespace texel::grade
