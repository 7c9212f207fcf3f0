// SPDX-License-Identifier: MIT
#include "grade/grader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sodium.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>
#include <thread>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/parallel.hpp"
#include "core/stopwatch.hpp"
#include "course/markers.hpp"
#include "course_side.hpp"
#include "fingerprint.hpp"
#include "grade/judge.hpp"
#include "grade/plan.hpp"
#include "grade/store.hpp"
#include "grade/submission.hpp"
#include "kept.hpp"
#include "lock.hpp"
#include "studio.hpp"
#include "text.hpp"
#include "workshop.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// The course's secret, from which hidden cases are drawn.
std::string read_seed(const fs::path& file) {
  if (!fs::exists(file)) {
    std::array<unsigned char, 16> bytes{};
    if (sodium_init() < 0) throw Error::failed("the system has no source of random numbers");
    randombytes_buf(bytes.data(), bytes.size());
    write_file(file, fmt::format("{:02x}\n", fmt::join(bytes, "")));
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  }
  std::string seed = read_file(file);
  while (!seed.empty() && (seed.back() == '\n' || seed.back() == '\r' || seed.back() == ' ')) seed.pop_back();
  if (seed.size() < 8)
    throw Error::failed("does not contain a seed of at least 8 characters", {file.string()},
                        "write your course's secret into it");
  return seed;
}

/// A student whose labs are being graded. Opened by the first that comes, gone with the last.
struct Open {
  Entry entry;
  std::once_flag once;
  Submission submission;
  fs::path folder;                  ///< scratch
  std::set<std::string> done;       ///< cases that were judged before
  std::set<std::string> untouched;  ///< steps that are as the starter has them
  std::string incident;             ///< why it could not be opened
  std::atomic<std::size_t> left{0};
};

class ClassRun {
 public:
  ClassRun(const GradeOptions& options, const std::function<void(const std::string&)>& say)
      : options_(options), say_(say), jobs_(options.jobs > 0 ? options.jobs : processors()) {}

  GradeSummary run() {
    if (options_.shard < 1 || options_.shard > options_.shards)
      throw Error::usage(fmt::format("there is no shard {} of {}", options_.shard, options_.shards),
                         "shards are 1/4, 2/4, …");
    if (!options_.unsafe && !sandbox_fault().empty())
      throw Error::failed("the sandbox for the students' programs does not work: " + sandbox_fault());
    const std::vector<Entry> entries = chosen_entries();
    make_folders();
    const FileLock lock(options_.out / "lock", true);
    prepare();
    open_store();
    grade(entries);
    remove_unused(options_.cache);
    GradeSummary summary{entries.size(), judged_, 0, stopwatch_.milliseconds() / 1000 - ready_};
    for (const StudentResult& student : store_->read(graded_labs_).students)
      if (!student.incident.empty()) ++summary.incidents;
    return summary;
  }

 private:
  std::vector<Entry> chosen_entries() const {
    std::vector<Entry> entries = read_class(options_.class_folder);
    std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.id < b.id; });
    std::vector<Entry> chosen;
    for (std::size_t i = 0; i < entries.size(); ++i)
      if (i % options_.shards == options_.shard - 1) chosen.push_back(entries[i]);
    return chosen;
  }

  void make_folders() const {
    for (const fs::path& folder : {options_.out, options_.out / "pictures", options_.cache}) {
      std::error_code error;
      fs::create_directories(folder, error);
      if (error)
        throw Error::failed(fmt::format("cannot make the folder: {}", error.message()), {folder.string()},
                            "name a writable folder");
    }
  }

  /// The trusted side: starter, solution and what they draw.
  void prepare() {
    const std::vector<course::Lab> all = course::read_labs(options_.course / "labs");
    for (const course::Lab& lab : all)
      if (!lab.steps.empty() &&
          (options_.labs.empty() ||
           std::find(options_.labs.begin(), options_.labs.end(), lab.number) != options_.labs.end()))
        labs_.push_back(lab);
    if (labs_.empty()) throw Error::usage("none of these labs has steps");
    say_("preparing: starter, solution and references");
    seed_ = read_seed(options_.seed_file.empty() ? options_.out / "seed.txt" : options_.seed_file);
    const BuiltTree starter = starter_tree(options_.course, options_.cache);
    course_ = std::make_unique<CourseSide>(solution_tree(options_.course, options_.build, starter), starter,
                                           options_.cache, options_.context);
    workshop_ = std::make_unique<Workshop>(starter, options_.cache, options_.unsafe);
    starter_ = starter;
    allowed_ = step_files(starter.source);
    models_ = options_.cache / "models" / fingerprint({seed_}).substr(0, 16);
    graded_labs_ = with_needed(labs_, all);
    plans_ = plan(graded_labs_, seed_, models_);
    in_parallel(jobs_, plans_.size(), [&](std::size_t i) { course_->prepare(plans_[i]); });
    for (const LabPlan& plan : plans_) keep_references(plan);
    ready_ = stopwatch_.milliseconds() / 1000;
    say_(fmt::format("ready after {}", duration_text(ready_)));
  }

  /// The expected pictures of public cases, for the reports.
  void keep_references(const LabPlan& plan) const {
    const fs::path folder = options_.out / "references" / plan.lab.folder;
    fs::create_directories(folder);
    for (const Shot& shot : plan.shots) {
      if (shot.hidden) continue;
      const Expected expected = course_->expected(plan, shot);
      fs::copy_file(expected.reference, folder / shot.file(), fs::copy_options::overwrite_existing);
    }
  }

  void open_store() {
    store_ = std::make_unique<Store>(store_file(options_.out));
    std::map<std::string, std::string> facts;
    std::string labs;
    for (const course::Lab& lab : labs_) labs += fmt::format("{}{}", labs.empty() ? "" : " ", lab.number);
    facts["labs"] = labs;
    facts["seed"] = fingerprint({"seed", seed_}).substr(0, 12);
    facts["renderer"] = course_->renderer();
    facts["context"] = options_.context;
    std::string lists;
    for (const LabPlan& plan : plans_) lists += plan.batch();
    facts["course"] = fingerprint({starter_.fingerprint, lists}).substr(0, 12);
    const std::map<std::string, std::string> before = store_->facts();
    if (options_.resume && !before.empty()) {
      for (const auto& [name, value] : facts)
        if (const auto known = before.find(name); known == before.end() || known->second != value)
          throw Error::usage(
              fmt::format("the results in '{}' were graded with another {}", options_.out.string(), name),
              "leave out --resume to grade again from the start");
    } else if (!before.empty()) {
      store_->begin_anew(graded_labs_);
      fs::remove_all(options_.out / "pictures");
    }
    store_->put_facts(facts);
  }

  void grade(const std::vector<Entry>& entries) {
    const fs::path work = options_.out / "work";
    fs::remove_all(work);
    for (const LabPlan& plan : plans_) all_cases_ += plan.shots.size() * entries.size();
    // The students one after the other, each one's labs side by side: all processors are busy to the end, and
    // only few submissions are open at a time.
    const std::size_t count = entries.size() * plans_.size();
    std::mutex mutex;
    std::map<std::size_t, std::shared_ptr<Open>> open;
    in_parallel(jobs_, count, [&](std::size_t i) {
      const std::size_t index = i / plans_.size();
      std::shared_ptr<Open> student;
      {
        const std::scoped_lock lock(mutex);
        auto& slot = open[index];
        if (!slot) {
          slot = std::make_shared<Open>();
          slot->entry = entries[index];
          slot->folder = work / entries[index].id;
          slot->left = plans_.size();
        }
        student = slot;
      }
      std::call_once(student->once, [&] { open_student(*student); });
      grade_lab(*student, plans_[i % plans_.size()]);
      if (--student->left == 0) {
        fs::remove_all(student->folder);
        const std::scoped_lock lock(mutex);
        open.erase(index);
      }
    });
    fs::remove_all(work);
  }

  void open_student(Open& student) {
    StudentResult result;
    result.id = student.entry.id, result.name = student.entry.name, result.number = student.entry.number;
    std::string digest;
    try {
      student.submission = unpack(student.entry, allowed_);
      result.fault = student.submission.fault;
      result.ignored = worth_telling(student.submission.ignored);
      for (const auto& [path, text] : student.submission.files) digest = fingerprint({digest, path, text});
      digest = fingerprint({digest, result.fault});
      std::map<std::string, std::string> shaders;
      for (const auto& [path, text] : student.submission.files)
        if (path.starts_with("shaders/")) shaders[path.substr(8)] = text;
      fs::remove_all(student.folder);
      overlay(starter_.source / "shaders", shaders, student.folder / "root/shaders");
      fs::create_directory_symlink(starter_.source / "assets", student.folder / "root/assets");
      student.untouched = untouched(student.submission.files);
      store_->put_student(result, digest);
      student.done = store_->judged(result.id);
    } catch (const Error& error) {
      student.incident = error.what();
    } catch (const fs::filesystem_error& error) {
      student.incident = text_of(error);
    }
    // Known all the same, and with what was judged before.
    if (!student.incident.empty()) store_->put_student(result, "");
  }

  static std::string text_of(const fs::filesystem_error& error) {
    return fmt::format("{}: {}", error.path1().string(), error.code().message());
  }

  /// The steps between whose markers a submission has what the starter has.
  std::set<std::string> untouched(const std::map<std::string, std::string>& files) const {
    std::set<std::string> steps;
    for (const std::string& path : allowed_) {
      const std::string first = read_file(starter_.source / path);
      const auto file = files.find(path);
      steps.merge(course::untouched_steps(file == files.end() ? first : file->second, first, path));
    }
    return steps;
  }

  /// Files of the course that came back unchanged are no news; of the others the first hundred.
  std::vector<Ignored> worth_telling(const std::vector<Ignored>& ignored) const {
    std::vector<Ignored> told;
    for (const Ignored& file : ignored) {
      if (fs::exists(starter_.source / file.path)) continue;
      if (told.size() == 100) {
        told.push_back({"…", fmt::format("and more: {} files in all", ignored.size())});
        break;
      }
      told.push_back(file);
    }
    return told;
  }

  void grade_lab(Open& student, const LabPlan& plan) {
    constexpr int tries = 2;
    std::string incident = student.incident;
    for (int i = 0; i < tries && (i == 0 || !incident.empty()); ++i) try {
        if (student.incident.empty()) {
          incident.clear();
          judge_lab(student, plan);
        }
      } catch (const Error& error) {
        incident = error.what();
      } catch (const fs::filesystem_error& error) {
        incident = text_of(error);
      }
    store_->put_incident(student.entry.id, plan.lab.folder, incident);
    progress();
  }

  void judge_lab(Open& student, const LabPlan& plan) {
    std::vector<std::string> names;
    for (const Shot& shot : plan.shots)
      if (student.done.count(plan.lab.folder + "/" + shot.graded.name) == 0)
        names.push_back(shot.graded.name);
    finished_ += plan.shots.size() - names.size();
    if (names.empty()) return;
    std::map<std::string, std::string> sources;
    for (const auto& [path, text] : student.submission.files)
      if (path.ends_with(".cpp")) sources[path] = text;
    const Program program = workshop_->make(plan.lab.program(), sources);
    for (const CompilerLog& log : program.refused) store_->put_log(student.entry.id, log);

    const fs::path out = student.folder / plan.lab.folder;
    Studio studio{program.file,    student.folder / "root",      options_.context,
                  options_.unsafe, {starter_.source / "assets"}, {}};
    if (fs::exists(models_)) studio.readable.push_back(models_);
    fs::remove_all(out);
    const Drawn drawn = student.submission.fault.empty() ? draw(studio, plan, names, out) : Drawn();
    store_->put_notes(student.entry.id, plan.lab.folder, drawn.notes);
    judge_shots(student, plan, names, program, drawn, out);
    fs::remove_all(out);
  }

  /// Judges what was drawn, step by step, since a mistake shows in all pictures of its step.
  void judge_shots(const Open& student, const LabPlan& plan, const std::vector<std::string>& names,
                   const Program& program, const Drawn& drawn, const fs::path& out) {
    for (const course::Step& step : plan.lab.steps) {
      std::vector<CaseResult> results;
      std::map<std::string, Failed> failed;
      for (const Shot& shot : plan.shots) {
        if (shot.graded.step != step.id) continue;
        if (std::find(names.begin(), names.end(), shot.graded.name) == names.end()) continue;
        results.push_back(judge_shot(student, plan, shot, program, drawn, out));
        if (results.back().passed) continue;
        // A folder or a link of a picture's name is no picture.
        Failed one;
        if (fs::is_regular_file(fs::symlink_status(out / shot.file()))) one.picture = out / shot.file();
        if (const auto said = drawn.said.find(shot.file()); said != drawn.said.end()) one.said = said->second;
        if (!one.picture.empty() || !one.said.empty()) failed[shot.graded.name] = one;
      }
      if (student.untouched.count(step.id) == 0)
        name_mistake(plan, step.id, failed, results);
      else if (student.submission.fault.empty())
        say_untouched(results);
      for (CaseResult& result : results) {
        if (const auto one = failed.find(result.name); one != failed.end() && !one->second.picture.empty())
          result.picture = keep_picture(student, plan, one->second.picture);
        store_->put(student.entry.id, result);
        ++judged_, ++finished_;
      }
    }
  }

  CaseResult judge_shot(const Open& student, const LabPlan& plan, const Shot& shot, const Program& program,
                        const Drawn& drawn, const fs::path& out) const {
    CaseResult result;
    result.lab = plan.lab.folder, result.step = shot.graded.step, result.name = shot.graded.name;
    result.view = shot.graded.view, result.hidden = shot.hidden, result.limit = shot.graded.limit;
    result.unit = unit_of(shot.graded.view);
    result.command = shot.hidden ? "" : command(plan, shot);
    if (!shot.hidden) result.reference = fmt::format("references/{}/{}", plan.lab.folder, shot.file());
    const Verdict verdict = judge(shot, course_->expected(plan, shot), out / shot.file());
    result.passed = verdict.passed, result.error = verdict.error;
    // Finding what scores 0 needs more pictures. They are drawn only if the case may score.
    const bool may_earn =
        !verdict.passed && std::isfinite(verdict.wrongness) && student.untouched.count(shot.graded.step) == 0;
    result.score = score(shot, verdict, may_earn ? course_->worthless(plan, shot) : 0);
    result.message = verdict.message;
    if (const auto fault = drawn.faults.find(shot.file()); fault != drawn.faults.end())
      result.message = without_our_folders(fault->second);
    if (!student.submission.fault.empty()) result.message = student.submission.fault;
    const std::string& file = place_of(shot.graded.step).file;
    for (const CompilerLog& log : program.refused)
      if (log.file == file && !result.passed)
        result.message = fmt::format("{} does not compile: {}", file, first_error(log.text));
    return result;
  }

  /// The program's text without the grader's own folders.
  [[nodiscard]] std::string without_our_folders(std::string text) const {
    for (const fs::path& folder : {models_, starter_.source, options_.out / "work"})
      for (std::size_t at = 0; (at = text.find(folder.string() + "/", at)) != text.npos;)
        text.erase(at, folder.string().size() + 1);
    return text;
  }

  const Place& place_of(const std::string& step) const {
    static const Place nowhere;
    const auto found = course_->places().find(step);
    return found == course_->places().end() ? nowhere : found->second;
  }

  static std::string first_error(const std::string& log) {
    std::size_t at = log.find("error:");
    if (at == log.npos) at = log.find("undefined reference");
    if (at == log.npos) at = 0;
    const std::size_t begin = log.rfind('\n', at) + 1;
    return log.substr(begin, log.find('\n', at) - begin);
  }

  /// A picture that changed through earlier steps does not score for this step.
  static void say_untouched(std::vector<CaseResult>& results) {
    for (CaseResult& result : results)
      if (!result.passed) result.score = 0, result.message = kUntouched + result.message;
  }

  void name_mistake(const LabPlan& plan, const std::string& step, const std::map<std::string, Failed>& failed,
                    std::vector<CaseResult>& results) {
    if (failed.empty()) return;
    const Mistake* mistake = course_->recognise(plan, step, failed);
    if (mistake == nullptr) return;
    for (CaseResult& result : results)
      if (failed.count(result.name) > 0) result.mistake = mistake->name, result.mistake_says = mistake->says;
  }

  std::string keep_picture(const Open& student, const LabPlan& plan, const fs::path& file) const {
    const fs::path place = fs::path("pictures") / student.entry.id / plan.lab.folder / file.filename();
    // What is larger than any sound picture of the cases is a stranger's joke.
    if (fs::file_size(file) > (8U << 20U)) return {};
    fs::create_directories((options_.out / place).parent_path());
    fs::copy_file(file, options_.out / place, fs::copy_options::overwrite_existing);
    return place.generic_string();
  }

  void progress() {
    const std::scoped_lock lock(say_mutex_);
    const double seconds = stopwatch_.milliseconds() / 1000 - ready_;
    if (seconds - said_ < 1 && finished_ < all_cases_) return;
    said_ = seconds;
    const double rate = static_cast<double>(judged_) / std::max(seconds, 1e-3);
    const double left = static_cast<double>(all_cases_ - std::min<std::size_t>(all_cases_, finished_));
    say_(fmt::format("{} of {} cases, {:.1f} a second, {} left", finished_.load(), all_cases_, rate,
                     rate > 0 ? duration_text(left / rate) : "?"));
  }

  const GradeOptions& options_;
  const std::function<void(const std::string&)>& say_;
  unsigned jobs_;
  Stopwatch stopwatch_;
  std::vector<course::Lab> labs_, graded_labs_;
  std::string seed_;
  BuiltTree starter_;
  std::unique_ptr<CourseSide> course_;
  std::unique_ptr<Workshop> workshop_;
  std::vector<std::string> allowed_;
  fs::path models_;
  std::vector<LabPlan> plans_;
  std::unique_ptr<Store> store_;
  std::atomic<std::size_t> judged_ = 0, finished_ = 0;
  std::size_t all_cases_ = 0;
  std::mutex say_mutex_;
  double ready_ = 0;  ///< seconds after the start: when the first student's turn came
  double said_ = 0;   ///< seconds after that: when `say_` was called last
};

}  // namespace

fs::path store_file(const fs::path& folder) {
  return folder / "results.sqlite";
}

GradeSummary grade_class(const GradeOptions& options, const std::function<void(const std::string&)>& say) {
  GradeOptions absolute = options;
  for (fs::path* path :
       {&absolute.class_folder, &absolute.out, &absolute.course, &absolute.build, &absolute.cache})
    *path = fs::absolute(*path).lexically_normal();
  for (fs::path* path : {&absolute.out, &absolute.cache})
    if (!path->has_filename()) *path = path->parent_path();
  return ClassRun(absolute, say).run();
}

ClassResult read_results(const fs::path& folder, const fs::path& course) {
  if (!fs::exists(store_file(folder)))
    throw Error::failed("contains no results", {folder.string()}, "name the folder that was given to --out");
  const Store store(store_file(folder));
  ClassResult results = store.read(course::read_labs(course / "labs"));
  const std::string chosen = " " + results.facts["labs"] + " ";
  const std::map<std::string, Place> places = step_places(course);
  for (StudentResult& student : results.students) {
    // Others were graded only for what theirs need.
    std::erase_if(student.labs, [&](const LabResult& lab) {
      return chosen.find(fmt::format(" {} ", lab.lab.number)) == std::string::npos;
    });
    for (LabResult& lab : student.labs)
      for (StepResult& step : lab.steps)
        if (const auto place = places.find(step.id); place != places.end())
          step.file = place->second.file, step.line = place->second.line;
  }
  return results;
}

}  // namespace texel::grade
