// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "cache.hpp"
#include "class_run.hpp"
#include "core/error.hpp"
#include "core/files.hpp"
#include "course/batch.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

store::StudentResult known(const Entry& entry) {
  store::StudentResult student;
  student.id = entry.id, student.name = entry.name, student.number = entry.number;
  return student;
}

/// What results depend on: two runs may only be joined where all of it is the same.
std::map<std::string, std::string> facts_of(const GradeOptions& options, const ClassSetup& setup) {
  std::string labs, lists;
  for (const course::Lab& lab : setup.labs) labs += fmt::format("{}{}", labs.empty() ? "" : " ", lab.number);
  for (const course::Lab& plan : setup.plans) lists += course::to_batch(plan.cases);
  return {{"labs", labs},
          {"seed", fingerprint({"seed", setup.seed}).substr(0, 12)},
          {"renderer", setup.course->renderer()},
          {"context", options.context},
          {"course", fingerprint({setup.starter.fingerprint, lists}).substr(0, 12)}};
}

}  // namespace

Record::Record(const GradeOptions& options, const ClassSetup& setup, const std::vector<Entry>& entries,
               std::function<void(const std::string&)> say)
    : options_(options),
      setup_(setup),
      say_(std::move(say)),
      store_(std::make_unique<store::Store>(store_file(options.out))) {
  const std::map<std::string, std::string> facts = facts_of(options, setup), before = store_->facts();
  if (options.resume && !before.empty()) {
    for (const auto& [name, value] : facts)
      if (const auto known = before.find(name); known == before.end() || known->second != value)
        throw Error::usage(
            fmt::format("the results in '{}' were graded with another {}", options.out.string(), name),
            "leave out --resume to grade again from the start");
  } else if (!before.empty()) {
    store_->begin_anew(setup.labs);
    fs::remove_all(options.out / "pictures");
  }
  store_->put_facts(facts);
  keep_references();
  for (const Entry& entry : entries) store_->expect_student(known(entry));
  for (const course::Lab& plan : setup.plans) cases_ += plan.cases.size() * entries.size();
}

void Record::keep_references() const {
  for (const course::Lab& plan : setup_.plans) {
    const fs::path folder = options_.out / "references" / plan.folder;
    make_folder(folder);
    for (const course::Case& one : plan.cases)
      if (!one.hidden) write_file(folder / one.file, read_file(setup_.course->expected(plan, one).reference));
  }
}

std::set<std::string> Record::begin(const Entry& entry, const StudentRun* run) {
  store::StudentResult student = known(entry);
  if (run == nullptr) {
    // Known all the same, and with what was judged before.
    store_->put_student(student, "");
    return {};
  }
  student.fault = run->submission().fault;
  student.ignored = run->worth_telling();
  for (const store::Ignored& copy : run->submission().copies) {
    const std::scoped_lock lock(mutex_);
    say_(fmt::format("{}: {} {}", entry.id, copy.path, copy.reason));
  }
  store_->put_student(student, run->digest());
  return store_->judged(student.id);
}

void Record::keep(const Entry& entry, judge::CaseResult result, const fs::path& picture) {
  // What is larger than any sound picture of the cases is a stranger's joke.
  constexpr std::uintmax_t most = 8U << 20U;
  if (!picture.empty() && fs::file_size(picture) <= most) {
    const fs::path place = fs::path("pictures") / entry.id / result.lab / result.file;
    fs::create_directories((options_.out / place).parent_path());
    fs::copy_file(picture, options_.out / place, fs::copy_options::overwrite_existing);
    result.picture = place.generic_string();
  }
  store_->put(entry.id, result);
  ++judged_, ++finished_;
}

void Record::begin_lab(const Entry& entry, const course::Lab& plan) {
  const std::scoped_lock lock(mutex_);
  running_[{entry.id, plan.folder}] = seconds();
}

void Record::end_lab(const Entry& entry, const course::Lab& plan, const JudgedLab& judged,
                     std::size_t judged_before, const std::string& incident) {
  for (const store::CompilerLog& log : judged.logs) store_->put_log(entry.id, log);
  if (incident.empty() && judged_before < plan.cases.size())
    store_->put_notes(entry.id, plan.folder, judged.notes);
  store_->put_incident(entry.id, plan.folder, incident);
  finished_ += judged_before;
  const std::scoped_lock lock(mutex_);
  took_[entry.id] += seconds() - running_[{entry.id, plan.folder}];
  running_.erase({entry.id, plan.folder});
  progress();
}

std::string Record::times_as_csv() const {
  std::vector<std::pair<double, std::string>> times;
  for (const auto& [id, time] : took_) times.emplace_back(time, id);
  std::ranges::sort(times, std::greater());
  std::string text = "id,seconds\n";
  for (const auto& [time, id] : times) text += fmt::format("{},{:.1f}\n", id, time);
  return text;
}

std::size_t Record::incidents() const {
  const std::vector<store::StudentResult> students = store_->read(setup_.labs).students;
  const auto sound = std::ranges::count(students, "", &store::StudentResult::incident);
  return students.size() - static_cast<std::size_t>(sound);
}

void Record::progress() {
  const double now = seconds();
  if (now - said_ < 1 && finished_ < cases_) return;
  said_ = now;
  const double rate = static_cast<double>(judged_) / std::max(now, 1e-3);
  const auto left = static_cast<double>(cases_ - std::min<std::size_t>(cases_, finished_));
  const auto longest = std::ranges::min_element(running_, {}, [](const auto& one) { return one.second; });
  const bool is_slow = longest != running_.end() && now - longest->second > 10;
  say_(fmt::format("{} of {} cases, {:.1f} a second, {} left{}", finished_.load(), cases_, rate,
                   rate > 0 ? duration_text(left / rate) : "?",
                   is_slow ? fmt::format("; {} runs {} for {}", longest->first.first, longest->first.second,
                                         duration_text(now - longest->second))
                           : ""));
}

}  // namespace texel::grade
