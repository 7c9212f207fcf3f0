// SPDX-License-Identifier: MIT
// Grades that survive: text of every kind, sudden ends, full disks, and files that are no store.
#include "store/store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <thread>

#include "../support/picture_files.hpp"
#include "../support/said.hpp"
#include "core/error.hpp"
#include "core/files.hpp"

namespace texel::store {
namespace {

namespace fs = std::filesystem;
using test::has;

/// A place for stores that no other test has, which may run at the same time.
class Folder : public test::TemporaryFolder {
 public:
  Folder() : TemporaryFolder("store") {}
};

const std::string nasty =
    "Robert'); DROP TABLE cases; -- \"x\" <script>alert('&amp;')</script> \\n \\ \t\r\n ?1 :a $b %s {} "
    "\xC3\xA4\xE2\x82\xAC\xF0\x9F\x8E\xA8 \xEF\xBF\xBD \xE2\x80\xAEgpj\x01 `=cmd|'/c calc'!A1`" +
    std::string("\0 NUL", 5);

std::vector<course::Lab> two_labs() {
  std::vector<course::Lab> labs(2);
  labs[0].folder = "01_quad";
  labs[1].folder = "02_multi";
  for (const char* id : {"1.1", "1.2", "2.1"}) {
    course::Step step;
    step.id = id;
    step.points = 2;
    if (step.id == "1.2") step.needs = {"1.1"};
    if (step.id == "2.1") step.needs = {"1.2"};
    labs[step.id == "2.1" ? 1 : 0].steps.push_back(step);
  }
  return labs;
}

StudentResult student_of(const std::string& id) {
  StudentResult student;
  student.id = id;
  student.name = "name of " + id;
  return student;
}

judge::CaseResult case_of(const std::string& step, const std::string& name, double score) {
  judge::CaseResult result;
  result.lab = step == "2.1" ? "02_multi" : "01_quad";
  result.step = step;
  result.name = name;
  result.score = score;
  result.status = score == 1 ? judge::CaseStatus::passed : judge::CaseStatus::failed;
  result.error = 1 - score;
  return result;
}

const StudentResult& student_in(const ClassResult& result, std::string_view id) {
  for (const StudentResult& student : result.students)
    if (student.id == id) return student;
  throw std::out_of_range(fmt::format("there is no student {}", id));
}

const judge::StepResult& step_in(const StudentResult& student, const std::string& id) {
  for (const judge::LabResult& lab : student.labs)
    for (const judge::StepResult& step : lab.steps)
      if (step.id == id) return step;
  throw std::out_of_range("there is no step " + id);
}

/// Something done that must end with an error; its exit code and text, or "3: no error".
std::string failure_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return fmt::format("{}: {}", static_cast<int>(error.exit_code()), error.what());
  }
  return "no error";
}

/// What a process of its own says; "" when it ended otherwise. GoogleTest's macros do not reach back.
std::string in_child(const std::function<std::string()>& work) {
  int ends[2];
  if (::pipe(ends) != 0) return "";
  const pid_t child = ::fork();
  if (child == 0) {
    std::string text;
    try {
      text = work();
    } catch (const std::exception& error) {
      text = std::string("unexpected: ") + error.what();
    }
    const bool is_written = ::write(ends[1], text.data(), text.size()) == static_cast<ssize_t>(text.size());
    ::_exit(is_written ? 0 : 1);
  }
  ::close(ends[1]);
  std::string text;
  char block[4096];
  for (ssize_t got = 0; (got = ::read(ends[0], block, sizeof block)) > 0;)
    text.append(block, static_cast<std::size_t>(got));
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? text : fmt::format("ended with {}", status);
}

/// Puts a small disk of its own on a folder, seen by this process only. Whether it could.
bool mount_small_disk(const fs::path& folder, const char* options) {
  const auto user = ::geteuid();
  const auto group = ::getegid();
  if (::unshare(CLONE_NEWNS | (user == 0 ? 0 : CLONE_NEWUSER)) != 0) return false;
  if (user != 0) {
    std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
    std::ofstream("/proc/self/setgroups") << "deny";
    std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
  }
  return ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
         ::mount("tmpfs", folder.c_str(), "tmpfs", 0, options) == 0;
}

constexpr const char* kNoMount = "this machine lets nobody mount";

TEST(Store, gives_back_every_field_of_a_case) {
  const Folder folder;
  judge::CaseResult result;
  result.lab = "01_quad";
  result.step = "1.1";
  result.name = "name " + nasty;
  result.view = course::View::lod;
  result.hidden = true;
  result.status = judge::CaseStatus::untouched;
  result.judged = judge::Judged::markers_lost;
  result.score = 0.1;  // has no end in binary
  result.error = 1.0 / 3.0;
  result.limit = 1e-300;
  result.message = "message " + nasty;
  result.mistake = "mistake " + nasty;
  result.mistake_says = "mistake_says " + nasty;
  result.command = "command " + nasty;
  result.picture = "picture " + nasty;
  result.reference = "reference " + nasty;
  judge::CaseResult plain = case_of("1.1", "plain", 1);
  plain.error = std::numeric_limits<double>::infinity();
  {
    Store store(folder / "store");
    store.put_student(student_of(nasty), "digest");
    store.put(nasty, result);
    store.put(nasty, plain);
  }
  const ClassResult read = Store(folder / "store").read(two_labs());
  const std::vector<judge::CaseResult>& cases = step_in(student_in(read, nasty), "1.1").cases;
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_EQ(cases[0], plain);
  EXPECT_EQ(cases[1], result);
}

TEST(Store, gives_back_every_field_of_a_student) {
  const Folder folder;
  StudentResult student;
  student.id = "id " + nasty;
  student.name = "name " + nasty;
  student.number = "number " + nasty;
  student.fault = "fault " + nasty;
  student.incident = "incident " + nasty;
  student.ignored = {{"z " + nasty, "reason " + nasty}, {"a", ""}};
  student.labs.resize(1);
  student.labs[0].lab = two_labs()[1];
  student.labs[0].notes = {"z " + nasty, "a"};
  {
    Store store(folder / "store");
    store.put_facts({{"renderer", nasty}, {"", ""}});
    store.put_student(student, "digest");
    store.put_log(student.id, {"z " + nasty, "gone"});
    store.put_log(student.id, {"z " + nasty, "text " + nasty});
    store.put_log(student.id, {"a", "\n\n"});
    store.put_student(student_of("a"), "digest");
  }
  const Store store(folder / "store");
  EXPECT_EQ(store.facts(), (std::map<std::string, std::string>{{"renderer", nasty}, {"", ""}}));
  const ClassResult read = store.read(two_labs());
  EXPECT_EQ(read.facts, store.facts());
  ASSERT_EQ(read.students.size(), 2U);
  EXPECT_EQ(read.students[0].id, "a");
  const StudentResult& found = read.students[1];
  EXPECT_EQ(found.id, student.id);
  EXPECT_EQ(found.name, student.name);
  EXPECT_EQ(found.number, student.number);
  EXPECT_EQ(found.fault, student.fault);
  EXPECT_EQ(found.incident, student.incident);
  ASSERT_EQ(found.ignored.size(), 2U);
  EXPECT_EQ(found.ignored[0].path, "z " + nasty);
  EXPECT_EQ(found.ignored[0].reason, "reason " + nasty);
  EXPECT_EQ(found.ignored[1].path, "a");
  EXPECT_EQ(found.logs, (std::vector<CompilerLog>{{"a", "\n\n"}, {"z " + nasty, "text " + nasty}}));
  ASSERT_EQ(found.labs.size(), 2U);
  EXPECT_EQ(found.labs[0].lab.folder, "01_quad");
  EXPECT_TRUE(found.labs[0].notes.empty());
  EXPECT_EQ(found.labs[1].notes, student.labs[0].notes);
}

TEST(Store, keeps_that_nothing_could_be_compared) {
  const Folder folder;
  Store store(folder / "store");
  store.put_student(student_of("jane"), "");
  judge::CaseResult result = case_of("1.1", "a", 0);
  result.error = std::numeric_limits<double>::quiet_NaN();
  store.put("jane", result);
  const ClassResult read = store.read(two_labs());
  EXPECT_TRUE(std::isnan(step_in(student_in(read, "jane"), "1.1").cases.at(0).error));
  EXPECT_TRUE(has(store.dump(), "\tnan\t")) << store.dump();
}

TEST(Store, refuses_a_score_that_is_none_and_a_student_that_is_unknown) {
  const Folder folder;
  Store store(folder / "store");
  store.put_student(student_of("jane"), "");
  for (const double score : {-0.01, 1.01, std::nan("")}) {
    const std::string error = failure_of([&] { store.put("jane", case_of("1.1", "a", score)); });
    EXPECT_TRUE(has(error, "3: ") && has(error, "a row breaks the store's rules")) << score << " " << error;
  }
  EXPECT_TRUE(
      has(failure_of([&] { store.put("john", case_of("1.1", "a", 1)); }), "a row breaks the store's rules"));
  EXPECT_TRUE(
      has(failure_of([&] { store.put_notes("john", "01_quad", {"a"}); }), "a row breaks the store's rules"));
  EXPECT_TRUE(
      has(failure_of([&] { store.put_incident("john", "01_quad", "a"); }), "a row breaks the store's rules"));
  EXPECT_TRUE(has(failure_of([&] { store.put_log("john", {"a", "b"}); }), "a row breaks the store's rules"));
  EXPECT_EQ(store.dump(), "students\tjane\t\tname of jane\t\t\n");
}

TEST(Store, replaces_an_earlier_result_of_the_same_case_and_no_other) {
  const Folder folder;
  Store store(folder / "store");
  store.put_student(student_of("jane"), "");
  store.put_student(student_of("john"), "");
  judge::CaseResult result = case_of("1.1", "a", 0);
  judge::CaseResult elsewhere = case_of("2.1", "a", 0.25);
  store.put("jane", result);
  store.put("jane", elsewhere);
  store.put("john", result);
  result.score = 1;
  result.status = judge::CaseStatus::passed;
  result.step = "1.2";
  store.put("jane", result);
  const ClassResult read = store.read(two_labs());
  EXPECT_TRUE(step_in(student_in(read, "jane"), "1.1").cases.empty());
  EXPECT_EQ(step_in(student_in(read, "jane"), "1.2").cases, std::vector<judge::CaseResult>{result});
  EXPECT_EQ(step_in(student_in(read, "jane"), "2.1").cases, std::vector<judge::CaseResult>{elsewhere});
  EXPECT_EQ(step_in(student_in(read, "john"), "1.1").score, 0);
}

TEST(Store, knows_what_need_not_be_judged_again) {
  const Folder folder;
  {
    Store store(folder / "store");
    store.put_student(student_of("jane"), "digest");
    store.put_student(student_of("john"), "digest");
    store.put("jane", case_of("1.1", "a", 0));
    store.put("jane", case_of("2.1", "a", 1));
    store.put("john", case_of("1.1", "b", 1));
  }
  Store store(folder / "store");
  store.put_student(student_of("jane"), "digest");
  EXPECT_EQ(store.judged("jane"), (std::set<std::string>{"01_quad/a", "02_multi/a"}));
  EXPECT_EQ(store.judged("john"), (std::set<std::string>{"01_quad/b"}));
  EXPECT_TRUE(store.judged("anna").empty());
}

TEST(Store, keeps_a_students_results_notes_and_incidents_when_the_run_is_taken_up_again) {
  const Folder folder;
  Store store(folder / "store");
  StudentResult jane = student_of("jane");
  jane.ignored = {{"a", "b"}, {"c", "d"}};
  jane.fault = "f";
  jane.incident = "i";
  store.put_student(jane, "digest");
  store.put_log("jane", {"a", "b"});
  store.put("jane", case_of("1.1", "a", 1));
  store.put_notes("jane", "01_quad", {"note", "another"});
  store.put_notes("jane", "02_multi", {"note 2"});
  store.put_incident("jane", "02_multi", "no memory");

  StudentResult again = student_of("jane");
  again.ignored = {{"e", "f"}};
  again.labs.resize(1);
  again.labs[0].lab = two_labs()[1];
  store.put_student(again, "digest");
  const ClassResult read = store.read(two_labs());
  const StudentResult& found = student_in(read, "jane");
  EXPECT_EQ(store.judged("jane").size(), 1U);
  EXPECT_EQ(found.ignored.size(), 1U);
  EXPECT_EQ(found.logs, (std::vector<CompilerLog>{{"a", "b"}}));
  EXPECT_EQ(found.fault, "");
  EXPECT_EQ(found.incident, "02_multi: no memory");
  EXPECT_EQ(found.labs[0].notes, (std::vector<std::string>{"note", "another"}));
  EXPECT_TRUE(found.labs[1].notes.empty());
}

TEST(Store, forgets_the_results_of_another_submission_but_no_override) {
  const Folder folder;
  Store store(folder / "store");
  store.put_student(student_of("john"), "digest");
  store.put("john", case_of("1.1", "a", 1));
  const std::string without_jane = store.dump();
  store.put_student(student_of("jane"), "digest");
  store.put("jane", case_of("1.1", "a", 1));
  store.put_log("jane", {"lab.cpp", "error"});
  store.put_notes("jane", "01_quad", {"note"});
  store.put_incident("jane", "01_quad", "no memory");
  store.put_override({"jane", "1.1", 0.5, "late"});
  store.put_student(student_of("jane"), "another");
  EXPECT_TRUE(store.judged("jane").empty());
  EXPECT_EQ(store.dump(), "students\tjane\tanother\tname of jane\t\t\n" + without_jane +
                              "overrides\tjane\t1.1\t0.5\tlate\n");
}

TEST(Store, keeps_the_results_of_a_submission_that_cannot_be_read_for_once) {
  const Folder folder;
  Store store(folder / "store");
  store.put_student(student_of("jane"), "digest");
  store.put("jane", case_of("1.1", "a", 1));
  const std::string before = store.dump();
  StudentResult unread = student_of("jane");
  unread.incident = "the disk does not answer";
  store.put_student(unread, "");
  EXPECT_EQ(store.read(two_labs()).students.at(0).incident, unread.incident);
  EXPECT_EQ(store.judged("jane").size(), 1U);
  store.put_student(student_of("jane"), "digest");
  EXPECT_EQ(store.dump(), before);
  store.put_student(student_of("jane"), "another");
  EXPECT_TRUE(store.judged("jane").empty());
}

TEST(Store, takes_notes_in_place_of_those_before) {
  const Folder folder;
  Store store(folder / "store");
  store.put_student(student_of("jane"), "");
  store.put_notes("jane", "01_quad", {"a", "b", "c"});
  store.put_notes("jane", "02_multi", {"d"});
  store.put_notes("jane", "01_quad", {"e"});
  const ClassResult read = store.read(two_labs());
  EXPECT_EQ(read.students.at(0).labs.at(0).notes, std::vector<std::string>{"e"});
  EXPECT_EQ(read.students.at(0).labs.at(1).notes, std::vector<std::string>{"d"});
}

TEST(Store, keeps_incidents_apart_from_results_until_they_are_taken_back) {
  const Folder folder;
  Store store(folder / "store");
  StudentResult jane = student_of("jane");
  jane.incident = "unreadable";
  store.put_student(jane, "");
  store.put("jane", case_of("1.1", "a", 1));
  store.put_incident("jane", "02_multi", "no memory");
  store.put_incident("jane", "01_quad", "the renderer died");
  const ClassResult with = store.read(two_labs());
  EXPECT_EQ(with.students.at(0).incident, "unreadable\n01_quad: the renderer died\n02_multi: no memory");
  EXPECT_EQ(step_in(with.students[0], "1.1").score, 1);
  store.put_incident("jane", "01_quad", "");
  store.put_incident("jane", "02_multi", "no disk");
  EXPECT_EQ(store.read(two_labs()).students.at(0).incident, "unreadable\n02_multi: no disk");
}

TEST(Store, replaces_all_facts) {
  const Folder folder;
  Store store(folder / "store");
  EXPECT_TRUE(store.facts().empty());
  store.put_facts({{"a", "1"}, {"b", "2"}});
  store.put_facts({{"a", "3"}});
  EXPECT_EQ(store.facts(), (std::map<std::string, std::string>{{"a", "3"}}));
}

TEST(Store, reads_steps_as_their_cases_and_needs_say) {
  const Folder folder;
  Store store(folder / "store");
  store.put_student(student_of("jane"), "");
  store.put("jane", case_of("1.1", "a", 0.5));
  store.put("jane", case_of("1.2", "b", 1));
  store.put("jane", case_of("2.1", "c", 0));
  const ClassResult read = store.read(two_labs());
  EXPECT_EQ(step_in(read.students.at(0), "1.1").status, judge::Status::failed);
  EXPECT_EQ(step_in(read.students.at(0), "1.2").status, judge::Status::passed);
  EXPECT_EQ(step_in(read.students.at(0), "2.1").status, judge::Status::failed);
  EXPECT_DOUBLE_EQ(read.students.at(0).points(), 3);
}

TEST(Overrides, stand_for_the_judged_score) {
  const Folder folder;
  Store store(folder / "store");
  store.put_student(student_of("jane"), "");
  store.put("jane", case_of("1.1", "a", 0.25));
  store.put("jane", case_of("1.2", "b", 0));
  store.put("jane", case_of("2.1", "c", 1));
  store.put_override({"jane", "1.1", 1, "right, but written another way"});
  store.put_override({"jane", "1.2", 0.5, nasty});
  store.put_override({"jane", "2.1", 0, "copied"});
  store.put_override({"jane", "9.9", 1, "no such step"});
  store.put_override({"john", "1.1", 1, "no such student"});
  const ClassResult read = store.read(two_labs());
  const StudentResult& jane = student_in(read, "jane");
  EXPECT_EQ(step_in(jane, "1.1").score, 1);
  EXPECT_EQ(step_in(jane, "1.1").status, judge::Status::passed);
  EXPECT_EQ(step_in(jane, "1.1").overridden, "right, but written another way");
  EXPECT_EQ(step_in(jane, "1.2").score, 0.5);
  EXPECT_EQ(step_in(jane, "1.2").status, judge::Status::failed);
  EXPECT_EQ(step_in(jane, "1.2").overridden, nasty);
  EXPECT_EQ(step_in(jane, "2.1").score, 0);
  EXPECT_EQ(step_in(jane, "2.1").status, judge::Status::failed);
  EXPECT_DOUBLE_EQ(jane.points(), 3);
  EXPECT_EQ(read.students.size(), 1U);

  store.drop_override("jane", "1.1");
  const ClassResult without = store.read(two_labs());
  EXPECT_EQ(step_in(without.students.at(0), "1.1").score, 0.25);
  EXPECT_EQ(step_in(without.students.at(0), "1.1").overridden, "");
  EXPECT_EQ(step_in(without.students.at(0), "1.2").score, 0.5);
}

TEST(Overrides, survive_a_new_beginning_and_are_replaced_and_dropped_one_by_one) {
  const Folder folder;
  Store store(folder / "store");
  store.put_student(student_of("jane"), "");
  store.put_override({"jane", "1.2", 0.5, "b"});
  store.put_override({"jane", "1.1", 0.5, "a"});
  store.put_override({"anna", "2.1", 0.5, "c"});
  store.put_override({"jane", "1.1", 0.75, "d"});
  store.begin_anew(two_labs());
  store.put_student(student_of("jane"), "another");
  EXPECT_EQ(store.overrides(),
            (std::vector<Override>{
                {"anna", "2.1", 0.5, "c"}, {"jane", "1.1", 0.75, "d"}, {"jane", "1.2", 0.5, "b"}}));
  store.drop_override("jane", "1.1");
  store.drop_override("jane", "9.9");
  EXPECT_EQ(store.overrides(), (std::vector<Override>{{"anna", "2.1", 0.5, "c"}, {"jane", "1.2", 0.5, "b"}}));
}

TEST(Overrides, need_a_score_and_a_reason) {
  const Folder folder;
  Store store(folder / "store");
  for (const double score : {-0.5, 2.0, std::nan("")})
    EXPECT_TRUE(has(failure_of([&] {
                      store.put_override({"jane", "1.1", score, "a"});
                    }),
                    "2: the override"))
        << score;
  EXPECT_TRUE(has(failure_of([&] { store.put_override({"jane", "1.1", 1, ""}); }), "has no reason"));
  EXPECT_TRUE(store.overrides().empty());
}

TEST(Regrading, says_what_changed) {
  const Folder folder;
  Store store(folder / "store");
  const std::vector<course::Lab> labs = two_labs();
  const auto grade = [&](const std::string& id, double first, double second) {
    store.put_student(student_of(id), "");
    store.put(id, case_of("1.1", "a", first));
    store.put(id, case_of("1.2", "b", second));
  };
  store.begin_anew(labs);
  grade("jane", 0.25, 1);
  grade("john", 0.5, 0.5);
  grade("gone", 0.5, 0.5);
  EXPECT_TRUE(store.read(labs).changes.empty()) << "this was the first time";

  store.put_override({"john", "1.1", 1, "right"});
  store.begin_anew(labs);
  EXPECT_TRUE(store.read(labs).students.empty());
  EXPECT_TRUE(store.read(labs).changes.empty());
  EXPECT_TRUE(store.judged("jane").empty());
  grade("jane", 0.75, 1);
  grade("john", 0.75, 0.25);
  grade("anna", 1, 1);
  store.put_student(student_of("gone"), "");
  const std::vector<Change> changes = store.read(labs).changes;
  ASSERT_EQ(changes.size(), 2U)
      << "John's step 1.1 is the teacher's, Anna is new, nothing of Gone is judged yet";
  EXPECT_EQ(changes[0].student, "jane");
  EXPECT_EQ(changes[0].step, "1.1");
  EXPECT_EQ(changes[0].before, 0.25);
  EXPECT_EQ(changes[0].after, 0.75);
  EXPECT_EQ(changes[1].student, "john");
  EXPECT_EQ(changes[1].step, "1.2");
  EXPECT_EQ(changes[1].before, 0.5);
  EXPECT_EQ(changes[1].after, 0.25);
}

TEST(Regrading, compares_with_the_last_full_grades_when_it_was_cut_short) {
  const Folder folder;
  Store store(folder / "store");
  const std::vector<course::Lab> labs = two_labs();
  for (const char* id : {"jane", "john"}) {
    store.put_student(student_of(id), "");
    store.put(id, case_of("1.1", "a", 0.25));
  }
  store.begin_anew(labs);
  store.put_student(student_of("jane"), "");  // and here the power went
  store.begin_anew(labs);
  for (const char* id : {"jane", "john"}) {
    store.put_student(student_of(id), "");
    store.put(id, case_of("1.1", "a", 1));
  }
  const std::vector<Change> changes = store.read(labs).changes;
  ASSERT_EQ(changes.size(), 2U);
  EXPECT_EQ(changes[0].before, 0.25);
  EXPECT_EQ(changes[1].before, 0.25);
}

TEST(Regrading, counts_a_submission_that_became_unreadable) {
  const Folder folder;
  Store store(folder / "store");
  store.put_student(student_of("jane"), "");
  store.put("jane", case_of("1.1", "a", 0.25));
  store.begin_anew(two_labs());
  StudentResult broken = student_of("jane");
  broken.fault = "is no archive";
  store.put_student(broken, "another");
  const std::vector<Change> changes = store.read(two_labs()).changes;
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].after, 0);
}

/// One student with something in every table.
void fill(Store& store, const std::string& id, double score = 0.5) {
  StudentResult student = student_of(id);
  student.ignored = {{"a", nasty}};
  student.incident = "i";
  store.put_student(student, "digest of " + id);
  store.put(id, case_of("1.1", "a", score));
  store.put(id, case_of("2.1", nasty, 1));
  store.put_log(id, {"b", nasty});
  store.put_notes(id, "01_quad", {"note", nasty});
  store.put_incident(id, "02_multi", "no memory");
  store.put_override({id, "1.2", 0.5, nasty});
}

TEST(Dump, is_the_same_for_stores_that_say_the_same) {
  const Folder folder;
  Store a(folder / "a");
  Store b(folder / "b");
  a.put_facts({{"seed", "1"}, {"renderer", "2"}});
  fill(a, "jane");
  fill(a, "john");
  b.put_student(student_of("anna"), "");
  b.begin_anew(two_labs());
  fill(b, "john", 0.25);
  fill(b, "jane", 0.25);
  b.put_facts({{"renderer", "2"}, {"seed", "1"}});
  EXPECT_NE(a.dump(), b.dump());
  fill(b, "jane");
  fill(b, "john");
  EXPECT_EQ(a.dump(), b.dump());
}

TEST(Dump, has_every_row_on_a_line_of_its_own) {
  const Folder folder;
  Store store(folder / "store");
  store.put_facts({{"seed", "tab\tline\nback\\"}});
  store.put_student(student_of("jane"), "digest");
  store.put("jane", case_of("1.1", "a", 0.1));
  EXPECT_EQ(store.dump(),
            "facts\tseed\ttab\\tline\\nback\\\\\n"
            "students\tjane\tdigest\tname of jane\t\t\n"
            "cases\tjane\t01_quad\ta\t1.1\tcolor\t0\t0.1\t0.9\t0\t\t\t\t\t\t\tfailed\ttogether\n");
}

TEST(Merge, of_shards_says_what_one_store_of_all_says) {
  const Folder folder;
  Store all(folder / "all");
  Store a(folder / "a");
  Store b(folder / "b");
  Store nobody(folder / "nobody");
  for (Store* store : {&all, &a, &b, &nobody}) store->put_facts({{"seed", "1"}});
  for (Store* store : {&all, &a, &b}) {
    fill(*store, "old");
    if (store == &b) store->put_student(student_of("old"), "gone");
    store->begin_anew(two_labs());
  }
  fill(all, "jane");
  fill(a, "jane");
  fill(all, "john");
  fill(b, "john");

  Store joined(folder / "joined");
  joined.merge(a);
  joined.merge(nobody);
  EXPECT_EQ(joined.dump(), a.dump());
  joined.merge(Store(folder / "empty"));
  joined.merge(b);
  EXPECT_EQ(joined.dump(), all.dump());
  // Once more changes nothing, nor does a store of its own.
  joined.merge(a);
  joined.merge(joined);
  joined.merge(Store(folder / "joined"));
  EXPECT_EQ(joined.dump(), all.dump());
  EXPECT_EQ(Store(folder / "joined").dump(), all.dump());
}

TEST(Merge, refuses_stores_that_contradict_each_other_and_leaves_them) {
  const std::map<std::string, std::function<void(Store&)>> contradictions = {
      {"the student jane", [](Store& s) { s.put("jane", case_of("1.1", "a", 0.25)); }},
      {"disagree about the student jane", [](Store& s) { s.put("jane", case_of("1.2", "new", 1)); }},
      {"about the student jane", [](Store& s) { s.put_student(student_of("jane"), "another"); }},
      {"about the student jane",
       [](Store& s) {
         s.put_log("jane", {"b", "another"});
       }},
      {"student jane", [](Store& s) { s.put_notes("jane", "01_quad", {}); }},
      {"jane", [](Store& s) { s.put_incident("jane", "02_multi", ""); }},
      {"the override of step 1.2 of the student jane",
       [](Store& s) {
         s.put_override({"jane", "1.2", 0.5, "another"});
       }},
      {"graded differently: seed is '1' in one and '2' in",
       [](Store& s) {
         s.put_facts({{"seed", "2"}});
       }},
      {"new is not given in one and '' in",
       [](Store& s) {
         s.put_facts({{"new", ""}, {"seed", "1"}});
       }},
      {"seed is '1' in one and not given in", [](Store& s) { s.put_facts({}); }}};
  for (const auto& [what, contradict] : contradictions) {
    const Folder folder;
    Store a(folder / "a");
    Store b(folder / "b");
    for (Store* store : {&a, &b}) {
      store->put_facts({{"seed", "1"}});
      fill(*store, "jane");
    }
    fill(b, "anna");
    contradict(b);
    const std::string before = a.dump();
    const std::string error = failure_of([&] { a.merge(b); });
    EXPECT_TRUE(has(error, "2: ") && has(error, what)) << what << " | " << error;
    EXPECT_TRUE(has(error, folder / "a") && has(error, folder / "b")) << error;
    EXPECT_EQ(a.dump(), before);
  }
}

TEST(Merge, refuses_another_earlier_score) {
  const Folder folder;
  Store a(folder / "a");
  Store b(folder / "b");
  fill(a, "jane", 0.5);
  fill(b, "jane", 0.25);
  a.begin_anew(two_labs());
  b.begin_anew(two_labs());
  EXPECT_TRUE(has(failure_of([&] { a.merge(b); }), "the earlier score of step 1.1 of the student jane"));
}

TEST(Store, that_cannot_be_says_why_and_leaves_what_is_there) {
  const Folder folder;
  const auto open = [](const fs::path& file) { return failure_of([&] { Store store(file); }); };

  EXPECT_TRUE(has(open(folder / "none/store"), "its folder does not exist; make it first"));
  fs::create_directory(folder / "folder");
  EXPECT_TRUE(has(open(folder / "folder"), "is a folder, not a store of grades"));
  EXPECT_TRUE(fs::is_empty(folder / "folder"));

  // Shorter than SQLite's magic word, than its header, than its pages, and longer.
  for (const std::size_t size : {2U, 20U, 200U, 2000U, 100'000U}) {
    const std::string text(size, 'x');
    write_file(folder / "text", text);
    const std::string error = open(folder / "text");
    EXPECT_TRUE(has(error, "3: " + (folder / "text").string() + ": is not a store of grades; ")) << error;
    EXPECT_TRUE(read_file(folder / "text") == text) << size;
  }
  EXPECT_EQ(std::distance(fs::directory_iterator((folder / "x").parent_path()), {}), 2)
      << "nothing is left beside";
}

void run_sql(const fs::path& file, const char* sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  EXPECT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(database);
  sqlite3_close(database);
}

TEST(Store, leaves_databases_of_other_programs_and_versions) {
  const Folder folder;
  run_sql(folder / "other", "CREATE TABLE students (id); PRAGMA user_version = 1");
  for (const char* name : {"earlier", "later"}) const Store store(folder / name);
  run_sql(folder / "earlier", "PRAGMA user_version = 2");
  run_sql(folder / "later", "PRAGMA user_version = 4");
  const std::map<std::string, std::string> errors = {
      {"other", "is not a store of grades"},
      {"earlier", "the store has version 2, and this program writes version 3; use the program"},
      {"later", "the store has version 4, and this program writes version 3; use the program"}};
  for (const auto& [name, says] : errors) {
    const std::filesystem::path file = folder / name;
    const std::string before = read_file(file);
    const std::string error = failure_of([&] { Store store(file); });
    EXPECT_TRUE(has(error, "3: " + file.string()) && has(error, says)) << error;
    EXPECT_TRUE(read_file(file) == before) << name;
  }
}

TEST(Store, says_that_it_is_damaged) {
  const Folder folder;
  {
    Store store(folder / "store");
    StudentResult student = student_of("jane");
    for (int i = 0; i < 2000; ++i) student.ignored.push_back({std::to_string(i), nasty});
    store.put_student(student, "digest");
  }
  std::string bytes = read_file(folder / "store");
  ASSERT_GT(bytes.size(), 100'000U);
  std::fill(bytes.begin() + 20'000, bytes.end(), '\xAA');
  write_file(folder / "store", bytes);
  const std::string error = failure_of([&] { (void)Store(folder / "store").dump(); });
  EXPECT_TRUE(
      has(error, "3: " + (folder / "store").string() + ": the store is damaged; replace it by a backup"))
      << error;
}

TEST(Store, keeps_what_was_put_when_the_disk_is_full_and_goes_on_when_there_is_room) {
  const Folder folder;
  const std::string said = in_child([&]() -> std::string {
    if (!mount_small_disk(folder / ".", "size=512k")) return kNoMount;
    write_file(folder / "filler", std::string(200'000, 'x'));
    Store store(folder / "store");
    store.put_student(student_of("jane"), "digest");
    std::size_t put = 0;
    const auto put_one = [&] {
      judge::CaseResult result = case_of("1.1", fmt::format("{:04}", put), 1);
      result.message.assign(10'000, 'm');
      store.put("jane", result);
      ++put;
    };
    const std::string error = failure_of([&] {
      while (put < 1000) put_one();
    });
    const std::size_t put_before = put;
    const bool all_there = store.judged("jane").size() == put;
    const std::string opened = failure_of([&] { Store another(folder / "another"); });
    const std::string again = failure_of(put_one);
    fs::remove(folder / "filler");
    put_one();
    const bool more_there = store.judged("jane").size() == put && put == put_before + 1;
    store = Store(folder / "store");
    const bool still_there = store.judged("jane").size() == put;
    return fmt::format("{}|{}|{}|{}|{}|{}|{}", error, again, opened, put_before > 3, all_there, more_there,
                       still_there);
  });
  if (said == kNoMount) GTEST_SKIP() << said;
  const std::string full =
      "3: " + (folder / "store").string() + ": the disk is full; free some space and continue";
  EXPECT_TRUE(said.starts_with(full)) << said;
  EXPECT_TRUE(has(said, "|" + full)) << said;
  EXPECT_TRUE(has(said, "|3: " + (folder / "another").string() + ": the disk is full")) << said;
  EXPECT_TRUE(said.ends_with("|true|true|true|true")) << said;
}

TEST(Store, says_that_the_disk_is_full_when_it_is_opened) {
  const Folder folder;
  const std::string said = in_child([&]() -> std::string {
    if (!mount_small_disk(folder / ".", "size=512k,nr_inodes=5")) return kNoMount;
    {
      Store store(folder / "store");
      fill(store, "jane");
    }
    std::ofstream filler(folder / "filler");
    filler << std::string(1'000'000, 'x') << std::flush;
    const std::string full = failure_of([&] { (void)Store(folder / "store").dump(); });
    fs::resize_file(folder / "filler", 0);
    const std::string before = Store(folder / "store").dump();
    std::ofstream(folder / "one more");
    const std::string no_more_files = failure_of([&] { (void)Store(folder / "store").dump(); });
    fs::remove(folder / "one more");
    return fmt::format("{}|{}|{}", full, no_more_files, Store(folder / "store").dump() == before);
  });
  if (said == kNoMount) GTEST_SKIP() << said;
  const std::string file = "3: " + (folder / "store").string();
  EXPECT_TRUE(said.starts_with(file + ": the disk is full; free some space")) << said;
  EXPECT_TRUE(has(said, "|" + file + ": it or a file beside it cannot be opened; check that")) << said;
  EXPECT_TRUE(said.ends_with("|true")) << said;
}

TEST(Store, says_that_the_file_system_is_read_only) {
  const Folder folder;
  const std::string said = in_child([&]() -> std::string {
    if (!mount_small_disk(folder / ".", "size=1m")) return kNoMount;
    {
      Store store(folder / "store");
      fill(store, "jane");
    }
    if (::mount(nullptr, (folder / ".").c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr) != 0)
      return kNoMount;
    return failure_of([&] { Store store(folder / "store"); }) + "|" +
           failure_of([&] { Store store(folder / "another"); });
  });
  if (said == kNoMount) GTEST_SKIP() << said;
  const char* error =
      "3: {}: the store or its folder cannot be written; get write permission for both, or "
      "choose another folder";
  EXPECT_EQ(said, fmt::format(fmt::runtime(error), (folder / "store").string()) + "|" +
                      fmt::format(fmt::runtime(error), (folder / "another").string()));
}

TEST(Store, says_that_the_folder_or_file_cannot_be_written) {
  const Folder folder;
  for (const char* name : {"folder", "file"}) {
    fs::create_directory(folder / name);
    Store store(folder / name / "store");
    fill(store, "jane");
  }
  const auto may_read = fs::perms::owner_read | fs::perms::others_read;
  const auto may_enter = fs::perms::owner_exec | fs::perms::others_exec;
  fs::permissions(folder / "file/store", may_read);
  fs::permissions(folder / "file", fs::perms::all);
  fs::permissions(folder / "folder/store", fs::perms::all);
  fs::permissions(folder / "folder", may_read | may_enter);
  for (const char* name : {"folder/store", "file/store", "folder/another"}) {
    const std::string said = in_child([&] {
      // Root may write everywhere, nobody may not.
      if (::geteuid() == 0 && ::setuid(65534) != 0) return std::string("is root");
      return failure_of([&] {
        Store store(folder / name);
        store.put_facts({});
      });
    });
    EXPECT_TRUE(has(said, "3: " + (folder / name).string() + ": the store or its folder cannot be written"))
        << said;
  }
  fs::permissions(folder / "folder", fs::perms::owner_all);
}

TEST(Store, is_written_by_many_threads) {
  const Folder folder;
  Store store(folder / "store");
  Store other(folder / "store");
  store.put_student(student_of("jane"), "");
  std::vector<std::thread> threads;
  constexpr std::size_t kThreads = 4, kCases = 50;
  std::vector<std::string> errors(kThreads);
  for (std::size_t t = 0; t < kThreads; ++t)
    threads.emplace_back([&, t] {
      errors[t] = failure_of([&] {
        for (std::size_t i = 0; i < kCases; ++i)
          (t % 2 == 0 ? store : other).put("jane", case_of("1.1", fmt::format("{}-{}", t, i), 1));
      });
    });
  for (std::thread& thread : threads) thread.join();
  for (const std::string& error : errors) EXPECT_EQ(error, "no error");
  EXPECT_EQ(store.judged("jane").size(), kThreads * kCases);
}

TEST(Store, can_be_begun_by_many_at_once) {
  const Folder folder;
  for (int round = 0; round < 20; ++round) {
    std::vector<std::thread> threads;
    std::vector<std::string> errors(4);
    const fs::path file = folder / fmt::format("store{}", round);
    for (std::string& error : errors)
      threads.emplace_back([&] {
        error = failure_of([&] {
          Store store(file);
          store.put_override({"jane", std::to_string(&error - errors.data()), 1, "a"});
        });
      });
    for (std::thread& thread : threads) thread.join();
    for (const std::string& error : errors) ASSERT_EQ(error, "no error") << round;
    ASSERT_EQ(Store(file).overrides().size(), errors.size());
  }
}

TEST(Store, is_read_as_it_is_at_one_moment) {
  const Folder folder;
  Store writer(folder / "store");
  const Store reader(folder / "store");
  std::thread thread([&] {
    StudentResult student = student_of("jane");
    for (int i = 0; i < 200; ++i) {
      student.name = student.incident = std::to_string(i);
      writer.put_student(student, "digest");
    }
  });
  std::set<std::string> seen;
  while (!seen.contains("199")) {
    const std::vector<StudentResult> students = reader.read({}).students;
    if (students.empty()) continue;
    EXPECT_EQ(students[0].name, students[0].incident);
    seen.insert(students[0].name);
  }
  thread.join();
  EXPECT_GT(seen.size(), 1U);
}

/// Puts cases until it is killed, and says each that is put. The case "same" is of one letter every time.
[[noreturn]] void write_until_killed(const fs::path& file, int round, int pipe) {
  Store store(file);
  store.put_student(student_of("jane"), "digest");
  for (int i = 0;; ++i) {
    judge::CaseResult result = case_of("1.1", fmt::format("{}-{}", round, i), 1);
    store.put("jane", result);
    const std::string line = fmt::format("01_quad/{}\n", result.name);
    if (::write(pipe, line.data(), line.size()) < 0) ::_exit(1);
    result.name = "same";
    result.message.assign(20'000, static_cast<char>('a' + i % 26));  // takes several pages
    result.mistake = result.message.substr(0, 1);
    store.put("jane", result);
  }
}

TEST(Store, has_all_that_was_put_when_the_program_is_killed) {
  const Folder folder;
  const fs::path file = folder / "store";
  std::set<std::string> reported;
  for (int round = 0; round < 20; ++round) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const pid_t child = ::fork();
    if (child == 0) write_until_killed(file, round, ends[1]);
    ::close(ends[1]);
    // Not before some words, and then at another moment of its loop each time.
    char block[4096];
    std::string text;
    while (std::count(text.begin(), text.end(), '\n') <= round) {
      const ssize_t got = ::read(ends[0], block, sizeof block);
      ASSERT_GT(got, 0);
      text.append(block, static_cast<std::size_t>(got));
    }
    std::this_thread::sleep_for(std::chrono::microseconds(1700 * round));
    ::kill(child, SIGKILL);
    for (ssize_t got = 0; (got = ::read(ends[0], block, sizeof block)) > 0;)
      text.append(block, static_cast<std::size_t>(got));
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);

    std::size_t begin = 0;
    for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
      reported.insert(text.substr(begin, end - begin));
    ASSERT_TRUE(reported.contains(fmt::format("01_quad/{}-0", round)));

    const Store store(file);
    const std::set<std::string> judged = store.judged("jane");
    for (const std::string& name : reported) ASSERT_TRUE(judged.contains(name)) << name;
    const ClassResult read = store.read(two_labs());
    for (const judge::CaseResult& result : step_in(read.students.at(0), "1.1").cases) {
      if (result.name != "same") continue;
      ASSERT_EQ(result.message, std::string(20'000, result.mistake.at(0)));
    }
  }
}

TEST(Store, knows_who_is_to_be_graded_and_takes_nothing_from_who_was) {
  const Folder folder;
  Store store(folder / "results.sqlite");
  StudentResult broken = student_of("anna");
  broken.fault = "is empty";
  store.put_student(broken, "digest");
  store.put("anna", case_of("1.1", "plain", 0));
  store.expect_student(student_of("anna"));
  store.expect_student(student_of("ben"));
  const ClassResult result = store.read(two_labs());
  EXPECT_EQ(student_in(result, "anna").fault, "is empty");
  EXPECT_EQ(step_in(student_in(result, "anna"), "1.1").cases.size(), 1U);
  EXPECT_EQ(student_in(result, "ben").name, "name of ben");
  store.put_student(student_of("ben"), "another digest");
  store.put("ben", case_of("1.1", "plain", 1));
  EXPECT_EQ(step_in(student_in(store.read(two_labs()), "ben"), "1.1").score, 1);
}

}  // namespace
}  // namespace texel::store
