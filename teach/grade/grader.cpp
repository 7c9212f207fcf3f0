// SPDX-License-Identifier: MIT
#include "grade/grader.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <deque>
#include <memory>
#include <mutex>

#include "cache.hpp"
#include "class_run.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/stopwatch.hpp"
#include "material/starter.hpp"
#include "sandbox/sandbox.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// The students of this shard, by id.
std::vector<Entry> chosen_entries(const GradeOptions& options) {
  std::vector<Entry> entries = read_class(options.class_folder), chosen;
  std::ranges::sort(entries, {}, &Entry::id);
  for (std::size_t i = options.shard - 1; i < entries.size(); i += options.shards)
    chosen.push_back(entries[i]);
  return chosen;
}

// --- What must hold besides when programs run as another user ----------------------------------------------

constexpr fs::perms kOwn = fs::perms::owner_all;
constexpr fs::perms kEntered = kOwn | fs::perms::group_exec | fs::perms::others_exec;

/// Folders that only the grader may enter.
std::vector<fs::path> own_folders(const GradeOptions& options) {
  return {options.out / "pictures", options.out / "references", options.cache / "references",
          options.cache / "solutions"};
}

/// Closes to other users what the grader writes and no program of a student may read: the results, references
/// and the solutions' programs. The cache's other folders can be entered, but not listed.
void restrict_access(const GradeOptions& options) {
  try {
    for (const fs::path& folder : own_folders(options)) {
      fs::create_directories(folder);
      fs::permissions(folder, kOwn);
    }
    for (const fs::path& folder : {options.out, options.out / "work", options.cache,
                                   options.cache / "programs", options.cache / "objects"}) {
      fs::create_directories(folder);
      fs::permissions(folder, kEntered);
    }
    { const store::Store made(store_file(options.out)); }
    fs::permissions(store_file(options.out), fs::perms::owner_read | fs::perms::owner_write);
  } catch (const fs::filesystem_error& error) {
    throw Error::failed("cannot be closed to other users: " + error.code().message(),
                        {error.path1().string()});
  }
}

/// Tries as another user to read the course, its programs, the seed and what `restrict_access` closed, and to
/// write where a program could leave something for a later one. Throws Error (exit 3) with what is open.
void check_access(const GradeOptions& options) {
  std::vector<fs::path> secret = own_folders(options);
  for (const char* path : {"labs", "common", "shaders", "tests", ".git"})
    secret.push_back(options.course / path);
  secret.push_back(options.build / "bin");
  secret.push_back(store_file(options.out));
  secret.push_back(options.seed_file.empty() ? options.out / "seed.txt" : options.seed_file);
  std::vector<std::string> words = {"/bin/sh", "-c",
                                    "until [ \"$1\" = -- ]; do if [ -r \"$1\" ] || [ -x \"$1\" ]; then echo "
                                    "\"$1\"; fi; shift; done; shift; "
                                    "for f; do if [ -w \"$f\" ]; then echo \"$f\"; fi; done",
                                    "sh"};
  for (const fs::path& path : secret) words.push_back(fs::absolute(path).string());
  words.insert(words.end(), {"--", "/tmp", "/var/tmp", "/dev/shm", "/dev/mqueue", "/run/lock"});
  const Outcome outcome = sandbox::run_as_another_user({}, words);
  if (!outcome.succeeded()) throw Error::failed("cannot try what is open to other users: " + outcome.errors);
  if (outcome.output.empty()) return;
  std::string open = outcome.output;
  open.pop_back();
  std::replace(open.begin(), open.end(), '\n', ' ');
  throw Error::failed(
      "with --walls user, a student's programs could read the course or leave files in: " + open, {},
      "type chmod go-rwx for what is read, and chmod go-w for what is written");
}

// --- The students ------------------------------------------------------------------------------------------

/// What an exception says that nobody expected, from a full disk to a mistake of ours.
std::string incident_of(const std::exception& exception) {
  if (const auto* error = dynamic_cast<const fs::filesystem_error*>(&exception))
    return fmt::format("{}: {}", error->path1().string(), error->code().message());
  return exception.what();
}

/// A student whose labs are graded. The submission is opened with the first of them, and closed after the
/// last.
struct Student {
  Student(Entry entry_, std::size_t labs) : entry(std::move(entry_)), left(labs) {}

  Entry entry;
  std::atomic<std::size_t> left;  ///< labs
  std::once_flag once;
  std::unique_ptr<StudentRun> run;
  std::set<std::string> done;  ///< cases that were judged before
  std::string incident;        ///< why the submission could not be opened
};

void open_submission(const GradeOptions& options, const ClassSetup& setup, Record& record, Student& student) {
  try {
    student.run =
        std::make_unique<StudentRun>(setup, options, student.entry, options.out / "work" / student.entry.id);
    student.done = record.begin(student.entry, student.run.get());
  } catch (const std::exception& exception) {
    student.incident = incident_of(exception);
    student.run.reset();
    record.begin(student.entry, nullptr);
  }
}

/// Whatever happens in one lab is an incident of that lab, and never the end of the class's run.
void grade_lab(const course::Lab& plan, Record& record, Student& student) {
  std::vector<course::Case> cases;
  for (const course::Case& one : plan.cases)
    if (!student.done.contains(plan.folder + "/" + one.name)) cases.push_back(one);
  JudgedLab judged;
  std::string incident = student.incident;
  constexpr int tries = 2;
  for (int i = 0; i < tries && student.run && !cases.empty() && (i == 0 || !incident.empty()); ++i) try {
      incident.clear();
      judged = student.run->judge(plan, cases, std::bind_front(&Record::keep, &record, student.entry));
    } catch (const std::exception& exception) {
      incident = incident_of(exception);
    }
  record.end_lab(student.entry, plan, judged, plan.cases.size() - cases.size(), incident);
  if (--student.left == 0) student.run.reset();
}

/// The students one after the other, each one's labs side by side: all processors are busy to the end, and
/// only few submissions are open at a time.
void grade_students(const GradeOptions& options, const ClassSetup& setup, Record& record,
                    const std::vector<Entry>& entries, unsigned jobs) {
  const std::size_t labs = setup.plans.size();
  std::deque<Student> students;
  for (const Entry& entry : entries) students.emplace_back(entry, labs);
  in_parallel(jobs, entries.size() * labs, [&](std::size_t i) {
    Student& student = students[i / labs];
    const course::Lab& plan = setup.plans[i % labs];
    record.begin_lab(student.entry, plan);
    std::call_once(student.once, [&] { open_submission(options, setup, record, student); });
    grade_lab(plan, record, student);
  });
}

/// Counts a student's cases, and takes the marks from steps whose cases are not all judged.
void count_cases(store::StudentResult& student) {
  for (judge::LabResult& lab : student.labs)
    for (judge::StepResult& step : lab.steps) {
      const auto planned =
          static_cast<std::size_t>(std::ranges::count(lab.lab.cases, step.id, &course::Case::step));
      student.planned += planned;
      student.judged += std::min(step.cases.size(), planned);
      if (step.cases.size() >= planned || !step.overridden.empty()) continue;
      step.cases.clear();
      step.status = judge::Status::failed, step.score = 0;
      step.message = "This step is not judged yet.", step.mistake = step.mistake_says = "";
    }
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
  for (const fs::path& folder : {options.out, options.out / "pictures", options.cache}) make_folder(folder);
  const Descriptor lock = lock_file(options.out / "lock", true);
  // Two programs at a time could read each other's files. A sandbox's memory ends at 1 GiB.
  const auto memory = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) *
                      static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  const auto most = static_cast<unsigned>(std::max<std::uint64_t>(memory / ProcessLimits().memory, 1));
  const unsigned jobs = as_another_user ? 1 : options.jobs > 0 ? options.jobs : std::min(processors(), most);
  if (as_another_user) restrict_access(options);

  const Stopwatch stopwatch;
  if (options.run == sandbox::run_locked_in && !sandbox::memory_group_fault().empty())
    say("the kernel does not count the sandboxes' memory: " + sandbox::memory_group_fault());
  say("preparing: starter, solution and references");
  const ClassSetup setup = prepare(options, jobs);
  say(fmt::format("ready after {}", duration_text(stopwatch.milliseconds() / 1000)));
  Record record(options, setup, entries, say);
  fs::remove_all(options.out / "work");
  if (as_another_user) check_access(options);
  grade_students(options, setup, record, entries, jobs);
  fs::remove_all(options.out / "work");
  write_file(options.out / "times.csv", record.times_as_csv());
  remove_unused(options.cache);
  return {entries.size(), record.judged(), record.incidents(), record.seconds()};
}

store::ClassResult read_results(const fs::path& folder, const fs::path& course) {
  if (!fs::exists(store_file(folder)))
    throw Error::failed("contains no results", {folder.string()}, "name the folder that was given to --out");
  const store::Store store(store_file(folder));
  store::ClassResult results = store.read(course::read_labs(course / "labs"));
  const std::string chosen = " " + results.facts["labs"] + " ";
  const std::map<std::string, Place> places = material::first_places(course);
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
