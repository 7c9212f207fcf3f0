// SPDX-License-Identifier: MIT
// Grades that survive: text of every kind, sudden ends, full disks, and files that are no store.
#include "store/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sched.h>
#include <signal.h>
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
#include "core/plain_text.hpp"

namespace texel::store {
namespace {

namespace fs = std::filesystem;
using test::has;

const std::string nasty =
    "Robert'); DROP TABLE cases; -- \"x\" <script>alert('&amp;')</script> \\n \\ \t\r\n ?1 :a $b %s {} "
    "\xC3\xA4\xE2\x82\xAC\xF0\x9F\x8E\xA8 \xEF\xBF\xBD \xE2\x80\xAEgpj\x01 `=cmd|'/c calc'!A1`" +
    std::string("\0 NUL", 5);

std::vector<course::Lab> two_labs() {
  std::vector<course::Lab> labs(2);
  labs[0].folder = "01_quad";
  labs[0].steps = {{"1.1", "", 2, {}, {}}, {"1.2", "", 2, {"1.1"}, {}}};
  labs[1].folder = "02_multi";
  labs[1].steps = {{"2.1", "", 2, {"1.2"}, {}}};
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
  result.step = step, result.name = name;
  result.score = score, result.error = 1 - score;
  result.status = score == 1 ? judge::Status::passed : judge::Status::failed;
  return result;
}

/// That case's row in a dump.
std::string row_of(const std::string& student, const judge::CaseResult& one) {
  return fmt::format("cases\t{}\t{}\t{}\t{}\tcolor\t0\t{}\t{}\t0\t\t\t\t\t\t\t{}\ttogether\n", student,
                     one.lab, one.name, one.step, one.score, one.error, name_of(one.status));
}

const judge::StepResult& step_in(const StudentResult& student, const std::string& id) {
  for (const judge::LabResult& lab : student.labs)
    for (const judge::StepResult& step : lab.steps)
      if (step.id == id) return step;
  throw std::out_of_range("there is no step " + id);
}

/// The exit code and text of the error with which some work ends, or "no error".
std::string failure_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return fmt::format("{}: {}", static_cast<int>(error.exit_code()), error.what());
  }
  return "no error";
}

/// A place for stores that no other test has, which may run at the same time.
class StoreTest : public testing::Test {
 protected:
  [[nodiscard]] fs::path file(const std::string& name) const { return folder_ / name; }
  [[nodiscard]] std::string opening(const std::string& name) const {
    return failure_of([&] { (void)Store(file(name)).read({}); });
  }
  /// Every row of a store as a line of text with tabs, in the order of its key.
  [[nodiscard]] std::string dump(const std::string& name) const {
    const SQLite::Database database(file(name).string(), SQLite::OPEN_READWRITE);
    std::string text;
    for (const std::string table :
         {"facts", "students", "ignored", "logs", "notes", "incidents", "cases", "overrides", "earlier"}) {
      SQLite::Statement row(
          database, fmt::format("SELECT * FROM {} ORDER BY {}", table, table == "facts" ? "1" : "1, 2, 3"));
      for (; row.executeStep(); text += '\n') {
        text += table;
        for (int i = 0; i < row.getColumnCount(); ++i) {
          const SQLite::Column value = row.getColumn(i);
          text += '\t' + (value.isText()   ? value.getString()
                          : value.isNull() ? "NULL"
                                           : fmt::format("{}", value.getDouble()));
        }
      }
    }
    return text;
  }
  /// One student with something in every table.
  static void fill(Store& store, const std::string& id, double score = 0.5) {
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

  const test::TemporaryFolder folder_;
};

TEST_F(StoreTest, gives_back_every_field) {
  StudentResult student;
  student.id = "id " + nasty, student.name = "name " + nasty, student.number = "number " + nasty;
  student.fault = "fault " + nasty, student.incident = "incident " + nasty;
  student.ignored = {{"z " + nasty, "reason " + nasty}, {"a", ""}};
  student.labs.resize(1);
  student.labs[0].lab = two_labs()[1];
  student.labs[0].notes = {"z " + nasty, "a"};
  judge::CaseResult result;
  result.lab = "01_quad", result.step = "1.1", result.name = "name " + nasty;
  result.view = course::View::lod, result.hidden = true;
  result.status = judge::Status::untouched, result.judged = judge::Judged::markers_lost;
  result.score = 0.1, result.error = 1.0 / 3.0;  // have no end in binary
  result.limit = 1e-300;
  result.message = "message " + nasty, result.command = "command " + nasty;
  result.mistake = "mistake " + nasty, result.mistake_says = "says " + nasty;
  result.picture = "picture " + nasty, result.reference = "reference " + nasty;
  judge::CaseResult plain = case_of("1.1", "plain", 1), none = case_of("1.2", "none", 0);
  plain.error = std::numeric_limits<double>::infinity();
  none.error = std::nan("");  // nothing could be compared
  const std::map<std::string, std::string> facts = {{"renderer", nasty}, {"", ""}};
  {
    Store store(file("store"));
    store.put_facts({{"renderer", "gone"}, {"gone", ""}});
    store.put_facts(facts);
    store.put_student(student, "digest");
    for (const judge::CaseResult& one : {result, plain, none}) store.put(student.id, one);
    for (const CompilerLog& log :
         {CompilerLog{"z " + nasty, "gone"}, {"z " + nasty, "text " + nasty}, {"a", "\n\n"}})
      store.put_log(student.id, log);
    store.put_student(student_of("a"), "digest");
  }
  const Store store(file("store"));
  EXPECT_EQ(store.facts(), facts);
  EXPECT_TRUE(has(dump("store"), "\tNULL\t"));
  const ClassResult read = store.read(two_labs());
  EXPECT_EQ(read.facts, facts);
  ASSERT_EQ(read.students.size(), 2U);
  EXPECT_EQ(read.students[0].id, "a");
  const StudentResult& found = read.students[1];
  EXPECT_EQ(std::tie(found.id, found.name, found.number, found.fault, found.incident),
            std::tie(student.id, student.name, student.number, student.fault, student.incident));
  ASSERT_EQ(found.ignored.size(), 2U);
  EXPECT_EQ(found.ignored[0].path, "z " + nasty);
  EXPECT_EQ(found.ignored[0].reason, "reason " + nasty);
  EXPECT_EQ(found.ignored[1].path, "a");
  EXPECT_EQ(found.logs, (std::vector<CompilerLog>{{"a", "\n\n"}, {"z " + nasty, "text " + nasty}}));
  ASSERT_EQ(found.labs.size(), 2U);
  EXPECT_EQ(found.labs[0].lab.folder, "01_quad");
  EXPECT_TRUE(found.labs[0].notes.empty());
  EXPECT_EQ(found.labs[1].notes, student.labs[0].notes);
  EXPECT_EQ(step_in(found, "1.1").cases, (std::vector<judge::CaseResult>{plain, result}));
  EXPECT_TRUE(std::isnan(step_in(found, "1.2").cases.at(0).error));
}

TEST_F(StoreTest, refuses_a_score_that_is_none_and_a_student_that_is_unknown) {
  Store store(file("store"));
  store.put_student(student_of("jane"), "");
  const std::string before = dump("store");
  const CompilerLog log{"a", "b"};
  const std::function<void()> refusals[] = {[&] { store.put("jane", case_of("1.1", "a", -0.01)); },
                                            [&] { store.put("jane", case_of("1.1", "a", 1.01)); },
                                            [&] { store.put("jane", case_of("1.1", "a", NAN)); },
                                            [&] { store.put("john", case_of("1.1", "a", 1)); },
                                            [&] { store.put_notes("john", "01_quad", {"a"}); },
                                            [&] { store.put_incident("john", "01_quad", "a"); },
                                            [&] { store.put_log("john", log); }};
  for (const std::function<void()>& refused : refusals) {
    const std::string error = failure_of(refused);
    EXPECT_TRUE(error.starts_with("3: ") && has(error, "a row breaks the store's rules")) << error;
    EXPECT_EQ(dump("store"), before);
  }
}

/// What is done with a store of Jane, and the rows that it then has.
struct Put {
  const char* why;
  std::function<void(Store&)> done;
  std::string rows;
};

TEST_F(StoreTest, has_the_rows_that_follow_from_what_was_put) {
  const std::string jane = "students\tjane\tdigest\tname of jane\t\t\n",
                    john = "students\tjohn\tdigest\tname of john\t\t\n";
  const judge::CaseResult a0 = case_of("1.1", "a", 0), a1 = case_of("1.2", "a", 1),
                          other = case_of("2.1", "a", 0.25);
  const auto fill_jane = [&](Store& s) {
    s.put("jane", a1);
    s.put_log("jane", {"lab.cpp", "error"});
    s.put_notes("jane", "01_quad", {"note", "another"});
    s.put_notes("jane", "02_multi", {"note 2"});
    s.put_incident("jane", "02_multi", "no memory");
    s.put_override({"jane", "1.1", 0.5, "late"});
  };
  const std::string overridden = "overrides\tjane\t1.1\t0.5\tlate\n";
  const std::vector<Put> changes = {
      {"a result replaces an earlier one of the same case, and no other",
       [&](Store& s) {
         s.put_student(student_of("john"), "digest");
         for (const judge::CaseResult& one : {a0, other, a1}) s.put("jane", one);
         s.put("john", a0);
       },
       jane + john + row_of("jane", a1) + row_of("jane", other) + row_of("john", a0)},
      {"notes replace those before",
       [](Store& s) {
         s.put_notes("jane", "01_quad", {"a", "b", "c"});
         s.put_notes("jane", "02_multi", {"d"});
         s.put_notes("jane", "01_quad", {"e"});
       },
       jane + "notes\tjane\t01_quad\t1\te\nnotes\tjane\t02_multi\t1\td\n"},
      {"incidents are replaced and taken back",
       [](Store& s) {
         s.put_incident("jane", "02_multi", "no memory");
         s.put_incident("jane", "01_quad", "the renderer died");
         s.put_incident("jane", "01_quad", "");
         s.put_incident("jane", "02_multi", "no disk");
       },
       jane + "incidents\tjane\t02_multi\tno disk\n"},
      {"of a student who is graded on, results, logs, and other labs' notes and incidents stay",
       [&](Store& s) {
         StudentResult first = student_of("jane");
         first.ignored = {{"a", "b"}, {"c", "d"}};
         first.fault = "f", first.incident = "i";
         s.put_student(first, "digest");
         fill_jane(s);
         StudentResult again = student_of("jane");
         again.ignored = {{"e", "f"}};
         again.labs.resize(1);
         again.labs[0].lab = two_labs()[1];
         s.put_student(again, "digest");
       },
       jane +
           "ignored\tjane\t1\te\tf\nlogs\tjane\tlab.cpp\terror\nnotes\tjane\t01_quad\t1\tnote\n"
           "notes\tjane\t01_quad\t2\tanother\nincidents\tjane\t02_multi\tno memory\n" +
           row_of("jane", a1) + overridden},
      {"of another submission nothing but overrides stays",
       [&](Store& s) {
         s.put_student(student_of("john"), "digest");
         s.put("john", a1);
         fill_jane(s);
         s.put_student(student_of("jane"), "another");
       },
       "students\tjane\tanother\tname of jane\t\t\n" + john + row_of("john", a1) + overridden},
      {"of one that cannot be read for once all stays",
       [&](Store& s) {
         s.put("jane", a1);
         StudentResult unread = student_of("jane");
         unread.incident = "the disk does not answer";
         s.put_student(unread, "");
       },
       jane + "incidents\tjane\t\tthe disk does not answer\n" + row_of("jane", a1)},
      {"and goes when there is another in its place",
       [&](Store& s) {
         s.put("jane", a1);
         s.put_student(student_of("jane"), "");
         s.put_student(student_of("jane"), "another");
       },
       "students\tjane\tanother\tname of jane\t\t\n"},
      {"one who is to be graded is known; from who was, nothing is taken",
       [&](Store& s) {
         StudentResult broken = student_of("jane");
         broken.fault = "is empty";
         s.put_student(broken, "digest");
         s.put("jane", a0);
         s.expect_student(student_of("jane"));
         s.expect_student(student_of("ben"));
         s.put_student(student_of("ben"), "another");
         s.put("ben", a1);
         s.expect_student(student_of("tom"));
       },
       "students\tben\tanother\tname of ben\t\t\nstudents\tjane\tdigest\tname of jane\t\tis empty\n"
       "students\ttom\t\tname of tom\t\t\n" +
           row_of("ben", a1) + row_of("jane", a0)},
      {"overrides are replaced and dropped one by one, and outlast a new beginning",
       [](Store& s) {
         for (const Override& one : {Override{"jane", "1.2", 0.5, "b"},
                                     {"jane", "1.1", 0.5, "a"},
                                     {"anna", "2.1", 0.5, "c"},
                                     {"jane", "1.1", 0.75, "d"}})
           s.put_override(one);
         s.begin_anew(two_labs());
         s.drop_override("jane", "1.2");
         s.drop_override("jane", "9.9");
       },
       "overrides\tanna\t2.1\t0.5\tc\noverrides\tjane\t1.1\t0.75\td\nearlier\tjane\t1.1\t0.75\n"
       "earlier\tjane\t1.2\t0.5\n"},
  };
  for (const auto& [why, done, rows] : changes) {
    fs::remove(file("store"));
    Store store(file("store"));
    store.put_student(student_of("jane"), "digest");
    done(store);
    EXPECT_EQ(dump("store"), rows) << why;
  }
}

TEST_F(StoreTest, reads_steps_as_their_cases_and_overrides_say) {
  Store store(file("store"));
  StudentResult unreadable = student_of("jane");
  unreadable.incident = "unreadable";
  store.put_student(unreadable, "");
  store.put_incident("jane", "02_multi", "no memory");
  store.put_incident("jane", "01_quad", "the renderer died");
  for (const auto& [step, score] : {std::pair("1.1", 0.25), {"1.2", 1.0}, {"2.1", 0.0}})
    store.put("jane", case_of(step, step, score));
  EXPECT_EQ(store.judged("jane"), (std::set<std::string>{"01_quad/1.1", "01_quad/1.2", "02_multi/2.1"}));
  EXPECT_TRUE(store.judged("john").empty());
  const auto expect = [&](double points,
                          const std::vector<std::tuple<std::string, double, judge::Status>>& steps) {
    const ClassResult read = store.read(two_labs());
    ASSERT_EQ(read.students.size(), 1U);
    const StudentResult& jane = read.students[0];
    EXPECT_DOUBLE_EQ(jane.points(), points);
    EXPECT_EQ(jane.incident, "unreadable\n01_quad: the renderer died\n02_multi: no memory");
    for (const auto& [id, score, status] : steps) {
      EXPECT_EQ(step_in(jane, id).score, score) << id;
      EXPECT_EQ(step_in(jane, id).status, status) << id;
    }
  };
  expect(2.5, {{"1.1", 0.25, judge::Status::failed},
               {"1.2", 1, judge::Status::passed},
               {"2.1", 0, judge::Status::failed}});
  store.put_override({"jane", "1.1", 1, "right, but written another way"});
  store.put_override({"jane", "1.2", 0.75, "copied"});
  store.put_override({"jane", "2.1", 0.5, nasty});
  store.put_override({"jane", "9.9", 1, "no such step"});
  store.put_override({"john", "1.1", 1, "no such student"});
  expect(4.5, {{"1.1", 1, judge::Status::passed},
               {"1.2", 0.75, judge::Status::failed},
               {"2.1", 0.5, judge::Status::failed}});
  const ClassResult read = store.read(two_labs());
  EXPECT_EQ(step_in(read.students[0], "1.1").overridden, "right, but written another way");
  EXPECT_EQ(step_in(read.students[0], "2.1").overridden, nasty);
  store.drop_override("jane", "1.1");
  expect(3, {{"1.1", 0.25, judge::Status::failed}, {"1.2", 0.75, judge::Status::failed}});
  EXPECT_EQ(step_in(store.read(two_labs()).students[0], "1.1").overridden, "");
}

TEST_F(StoreTest, takes_no_override_without_a_score_and_a_reason) {
  Store store(file("store"));
  for (const double score : {-0.5, 2.0, std::nan("")})
    EXPECT_TRUE(has(failure_of([&] {
                      store.put_override({"jane", "1.1", score, "a"});
                    }),
                    "2: the override"))
        << score;
  EXPECT_TRUE(has(failure_of([&] { store.put_override({"jane", "1.1", 1, ""}); }), "has no reason"));
  EXPECT_EQ(dump("store"), "");
}

/// A regrade of somebody's steps 1.1 and 1.2.
class Regrading : public StoreTest {
 protected:
  void grade(const std::string& id, double first, double second) {
    store_.put_student(student_of(id), "");
    store_.put(id, case_of("1.1", "a", first));
    store_.put(id, case_of("1.2", "b", second));
  }
  /// "jane 1.1: 0.25 to 0.75" for each.
  [[nodiscard]] std::vector<std::string> changes() const {
    std::vector<std::string> all;
    for (const auto& [student, step, before, after] : store_.read(two_labs()).changes)
      all.push_back(fmt::format("{} {}: {} to {}", student, step, before, after));
    return all;
  }
  using Changes = std::vector<std::string>;

  Store store_{file("store")};
};

TEST_F(Regrading, says_what_changed) {
  store_.begin_anew(two_labs());
  grade("jane", 0.25, 1);
  grade("john", 0.5, 0.5);
  grade("gone", 0.5, 0.5);
  EXPECT_EQ(changes(), Changes()) << "this was the first time";

  store_.put_override({"john", "1.1", 1, "right"});
  store_.begin_anew(two_labs());
  EXPECT_TRUE(store_.read(two_labs()).students.empty());
  EXPECT_EQ(changes(), Changes());
  EXPECT_TRUE(store_.judged("jane").empty());
  grade("jane", 0.75, 1);
  grade("john", 0.75, 0.25);
  grade("anna", 1, 1);
  store_.put_student(student_of("gone"), "");
  EXPECT_EQ(changes(), (Changes{"jane 1.1: 0.25 to 0.75", "john 1.2: 0.5 to 0.25"}))
      << "John's step 1.1 is the teacher's, Anna is new, nothing of Gone is judged yet";
}

TEST_F(Regrading, compares_with_the_last_full_grades_when_it_was_cut_short) {
  for (const char* id : {"jane", "john"}) grade(id, 0.25, 1);
  store_.begin_anew(two_labs());
  store_.put_student(student_of("jane"), "");  // and here the power went
  store_.begin_anew(two_labs());
  for (const char* id : {"jane", "john"}) grade(id, 1, 1);
  EXPECT_EQ(changes(), (Changes{"jane 1.1: 0.25 to 1", "john 1.1: 0.25 to 1"}));
}

TEST_F(Regrading, counts_a_submission_that_became_unreadable) {
  grade("jane", 0.25, 0);
  store_.begin_anew(two_labs());
  StudentResult broken = student_of("jane");
  broken.fault = "is no archive";
  store_.put_student(broken, "another");
  EXPECT_EQ(changes(), Changes{"jane 1.1: 0.25 to 0"});
}

TEST_F(StoreTest, merged_from_shards_says_what_one_store_of_all_says) {
  Store all(file("all")), a(file("a")), b(file("b")), nobody(file("nobody")), joined(file("joined"));
  for (Store* store : {&all, &a, &b, &nobody}) store->put_facts({{"seed", "1"}});
  for (Store* store : {&all, &a, &b}) {
    fill(*store, "old");
    if (store == &b) store->put_student(student_of("old"), "gone");
    store->begin_anew(two_labs());
  }
  fill(all, "jane");
  fill(a, "jane");
  fill(all, "john", 0.25);
  EXPECT_NE(dump("all"), dump("a"));
  fill(all, "john");
  fill(b, "john");

  joined.merge(a);
  joined.merge(nobody);
  EXPECT_EQ(dump("joined"), dump("a"));
  joined.merge(Store(file("empty")));
  joined.merge(b);
  EXPECT_EQ(dump("joined"), dump("all"));
  // Once more changes nothing, nor does a store of its own.
  joined.merge(a);
  joined.merge(joined);
  joined.merge(Store(file("joined")));
  EXPECT_EQ(dump("joined"), dump("all"));
}

TEST_F(StoreTest, merges_none_that_contradicts_it_and_leaves_both) {
  const CompilerLog log{"b", "another"};
  const Override another{"jane", "1.2", 0.5, "another"};
  const std::map<std::string, std::string> changed = {{"seed", "2"}}, further = {{"new", ""}, {"seed", "1"}};
  const std::pair<std::string, std::function<void(Store&)>> contradictions[] = {
      {"disagree about the student jane", [](Store& s) { s.put("jane", case_of("1.1", "a", 0.25)); }},
      {"disagree about the student jane", [](Store& s) { s.put("jane", case_of("1.2", "new", 1)); }},
      {"disagree about the student jane", [](Store& s) { s.put_student(student_of("jane"), "another"); }},
      {"disagree about the student jane", [](Store& s) { s.put_notes("jane", "01_quad", {}); }},
      {"disagree about the student jane", [](Store& s) { s.put_incident("jane", "02_multi", ""); }},
      {"disagree about the student jane", [&](Store& s) { s.put_log("jane", log); }},
      {"the override of step 1.2 of the student jane", [&](Store& s) { s.put_override(another); }},
      {"the earlier score of step 1.1 of the student old",
       [](Store& s) {
         fill(s, "old", 0.25);
         s.begin_anew(two_labs());
         fill(s, "jane");
       }},
      {"graded differently: seed is '1' in one and '2' in", [&](Store& s) { s.put_facts(changed); }},
      {"new is not given in one and '' in", [&](Store& s) { s.put_facts(further); }},
      {"seed is '1' in one and not given in", [](Store& s) { s.put_facts({}); }}};
  int number = 0;
  for (const auto& [what, contradict] : contradictions) {
    const std::string ours = fmt::format("a{}", ++number), theirs = fmt::format("b{}", number);
    Store a(file(ours)), b(file(theirs));
    for (Store* store : {&a, &b}) {
      store->put_facts({{"seed", "1"}});
      fill(*store, "old");
      store->begin_anew(two_labs());
      fill(*store, "jane");
    }
    fill(b, "anna");
    contradict(b);
    const std::string before = dump(ours), error = failure_of([&] { a.merge(b); });
    EXPECT_TRUE(has(error, "2: ") && has(error, what)) << what << " | " << error;
    EXPECT_TRUE(has(error, file(ours)) && has(error, file(theirs))) << error;
    EXPECT_EQ(dump(ours), before);
  }
}

TEST_F(StoreTest, that_cannot_be_says_why_and_leaves_what_is_there) {
  const auto run_sql = [&](const char* name, const char* sql) {
    SQLite::Database(file(name).string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(sql);
  };
  run_sql("other", "CREATE TABLE students (id); PRAGMA user_version = 1");
  for (const char* name : {"earlier", "later"}) const Store store(file(name));
  run_sql("earlier", "PRAGMA user_version = 2");
  run_sql("later", "PRAGMA user_version = 4");
  {
    Store store(file("damaged"));
    StudentResult student = student_of("jane");
    for (int i = 0; i < 2000; ++i) student.ignored.push_back({std::to_string(i), nasty});
    store.put_student(student, "digest");
  }
  std::string bytes = read_file(file("damaged"));
  ASSERT_GT(bytes.size(), 100'000U);
  std::fill(bytes.begin() + 20'000, bytes.end(), '\xAA');
  write_file(file("damaged"), bytes);
  std::vector<std::pair<std::string, std::string>> faults = {
      {"other", "is not a store of grades"},
      {"earlier", "the store has version 2, and this program writes version 3; use the program"},
      {"later", "the store has version 4, and this program writes version 3; use the program"},
      {"damaged", "the store is damaged; replace it by a backup"}};
  // Shorter than SQLite's magic word, than its header, than its pages, and longer.
  for (const std::size_t size : {2U, 20U, 200U, 2000U, 100'000U}) {
    write_file(file(std::to_string(size)), std::string(size, 'x'));
    faults.emplace_back(std::to_string(size), "is not a store of grades; ");
  }
  for (const auto& [name, says] : faults) {
    const std::string before = read_file(file(name)), error = opening(name);
    EXPECT_TRUE(error.starts_with("3: " + file(name).string() + ": " + says)) << error;
    EXPECT_TRUE(read_file(file(name)) == before) << name;
    EXPECT_FALSE(name.size() < 7 && fs::exists(file(name + "-wal"))) << "nothing is left beside";
  }
  EXPECT_TRUE(has(opening("none/store"), "its folder does not exist; make it first"));
  fs::create_directory(file("folder"));
  EXPECT_TRUE(has(opening("folder"), "is a folder, not a store of grades"));
  EXPECT_TRUE(fs::is_empty(file("folder")));
}

/// What a process of its own says, which may mount disks, be another user, and be killed.
std::string in_child(const std::function<std::string()>& work) {
  const test::TemporaryFolder folder;
  std::ofstream said(folder / "said");  // opened before it is another user
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      said << work() << std::flush;
    } catch (const std::exception& error) {
      said << "unexpected: " << error.what() << std::flush;
    }
    ::_exit(said ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  const bool is_said = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  return is_said ? read_file(folder / "said") : fmt::format("ended with {}", status);
}

constexpr const char* kNoMount = "this machine lets nobody mount";

/// Stores on a small disk of their own, which only a process of its own sees.
class StoreOnDisk : public StoreTest {
 protected:
  [[nodiscard]] bool mount_small_disk(const char* options) const {
    const auto user = ::geteuid();
    const auto group = ::getegid();
    if (::unshare(CLONE_NEWNS | (user == 0 ? 0 : CLONE_NEWUSER)) != 0) return false;
    if (user != 0) {
      std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
      std::ofstream("/proc/self/setgroups") << "deny";
      std::ofstream("/proc/self/gid_map") << "0 " << group << " 1";
    }
    return ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
           ::mount("tmpfs", file(".").c_str(), "tmpfs", 0, options) == 0;
  }
  [[nodiscard]] std::string full(const char* name) const {
    return "3: " + file(name).string() +
           ": the disk is full; free some space and continue: earlier results are kept";
  }
  [[nodiscard]] std::string closed(const char* name) const {
    return "3: " + file(name).string() +
           ": the store or its folder cannot be written; get write permission for both, or choose another "
           "folder";
  }
};

TEST_F(StoreOnDisk, keeps_what_was_put_when_the_disk_is_full_and_goes_on_when_there_is_room) {
  const std::string said = in_child([&]() -> std::string {
    if (!mount_small_disk("size=512k")) return kNoMount;
    write_file(file("filler"), std::string(200'000, 'x'));
    Store store(file("store"));
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
    const bool all_there = put > 3 && store.judged("jane").size() == put;
    const std::string opened = opening("another"), again = failure_of(put_one);
    fs::remove(file("filler"));
    put_one();
    const bool more_there = store.judged("jane").size() == put && put == put_before + 1;
    return fmt::format("{}|{}|{}|{}|{}|{}", error, again, opened, all_there, more_there,
                       Store(file("store")).judged("jane").size() == put);
  });
  if (said == kNoMount) GTEST_SKIP() << said;
  EXPECT_EQ(said, full("store") + "|" + full("store") + "|" + full("another") + "|true|true|true");
}

TEST_F(StoreOnDisk, says_that_it_is_full_or_read_only_when_it_is_opened) {
  const std::string said = in_child([&]() -> std::string {
    if (!mount_small_disk("size=512k,nr_inodes=5")) return kNoMount;
    {
      Store store(file("store"));
      fill(store, "jane");
    }
    std::ofstream filler(file("filler"));
    filler << std::string(1'000'000, 'x') << std::flush;
    const std::string when_full = opening("store");
    fs::resize_file(file("filler"), 0);
    const std::string before = dump("store");
    std::ofstream(file("one more"));
    const std::string no_more_files = opening("store");
    fs::remove(file("one more"));
    const bool is_same = dump("store") == before;
    filler.close();
    if (::mount(nullptr, file(".").c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr) != 0) return kNoMount;
    return fmt::format("{}|{}|{}|{}|{}", when_full, no_more_files, is_same, opening("store"),
                       opening("another"));
  });
  if (said == kNoMount) GTEST_SKIP() << said;
  EXPECT_TRUE(said.starts_with(full("store") + "|3: " + file("store").string() +
                               ": it or a file beside it cannot be opened; check that"))
      << said;
  EXPECT_TRUE(said.ends_with("|true|" + closed("store") + "|" + closed("another"))) << said;
}

TEST_F(StoreOnDisk, says_that_the_folder_or_file_cannot_be_written) {
  for (const char* name : {"folder", "file"}) {
    fs::create_directory(file(name));
    Store store(file(name) / "store");
    fill(store, "jane");
  }
  const auto may_read = fs::perms::owner_read | fs::perms::others_read;
  const auto may_enter = fs::perms::owner_exec | fs::perms::others_exec;
  fs::permissions(file("file/store"), may_read);
  fs::permissions(file("file"), fs::perms::all);
  fs::permissions(file("folder/store"), fs::perms::all);
  fs::permissions(file("folder"), may_read | may_enter);
  for (const char* name : {"folder/store", "file/store", "folder/another"}) {
    const std::string said = in_child([&] {
      // Root may write everywhere, nobody may not.
      if (::geteuid() == 0 && ::setuid(65534) != 0) return std::string("is root");
      return failure_of([&] { Store(file(name)).put_facts({}); });
    });
    EXPECT_EQ(said, closed(name));
  }
  fs::permissions(file("folder"), fs::perms::owner_all);
}

/// Runs some work in so many threads; the errors with which they ended.
std::vector<std::string> in_threads(std::size_t count, const std::function<void(std::size_t)>& work) {
  std::vector<std::thread> threads;
  std::vector<std::string> errors(count);
  for (std::size_t t = 0; t < count; ++t)
    threads.emplace_back([&, t] { errors[t] = failure_of([&] { work(t); }); });
  for (std::thread& thread : threads) thread.join();
  return errors;
}

const std::vector<std::string> kNoErrors(4, "no error");

TEST_F(StoreTest, is_written_by_many_threads) {
  Store store(file("store")), other(file("store"));
  store.put_student(student_of("jane"), "");
  const auto put_50 = [&](std::size_t t) {
    for (int i = 0; i < 50; ++i)
      (t % 2 == 0 ? store : other).put("jane", case_of("1.1", fmt::format("{}-{}", t, i), 1));
  };
  EXPECT_EQ(in_threads(4, put_50), kNoErrors);
  EXPECT_EQ(store.judged("jane").size(), 200U);
}

TEST_F(StoreTest, can_be_begun_by_many_at_once) {
  for (int round = 0; round < 20; ++round) {
    const std::string name = fmt::format("store{}", round);
    const auto begin = [&](std::size_t t) {
      Store(file(name)).put_override({"jane", std::to_string(t), 1, "a"});
    };
    ASSERT_EQ(in_threads(4, begin), kNoErrors) << round;
    ASSERT_EQ(dump(name).size(), 4 * std::string("overrides\tjane\t0\t1\ta\n").size());
  }
}

TEST_F(StoreTest, is_read_as_it_is_at_one_moment) {
  Store writer(file("store"));
  const Store reader(file("store"));
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
[[noreturn]] void write_until_killed(const fs::path& file, int round, const fs::path& says) {
  std::ofstream said(says);
  Store store(file);
  store.put_student(student_of("jane"), "digest");
  for (int i = 0;; ++i) {
    judge::CaseResult result = case_of("1.1", fmt::format("{}-{}", round, i), 1);
    store.put("jane", result);
    if (!(said << fmt::format("01_quad/{}\n", result.name) << std::flush)) ::_exit(1);
    result.name = "same";
    result.message.assign(20'000, static_cast<char>('a' + i % 26));  // takes several pages
    result.mistake = result.message.substr(0, 1);
    store.put("jane", result);
  }
}

TEST_F(StoreTest, has_all_that_was_put_when_the_program_is_killed) {
  std::set<std::string> reported;
  for (int round = 0; round < 20; ++round) {
    const fs::path says = file(fmt::format("said{}", round));
    write_file(says, "");
    const pid_t child = ::fork();
    if (child == 0) write_until_killed(file("store"), round, says);
    int status = 0;
    // Not before some words, and then at another moment of its loop each time.
    while (lines_of(read_file(says)).size() <= static_cast<std::size_t>(round) &&
           ::waitpid(child, &status, WNOHANG) == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::microseconds(1700 * round));
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    for (const std::string& name : lines_of(read_file(says))) reported.insert(name);
    ASSERT_TRUE(reported.contains(fmt::format("01_quad/{}-0", round)));
    const Store store(file("store"));
    const std::set<std::string> judged = store.judged("jane");
    for (const std::string& name : reported) ASSERT_TRUE(judged.contains(name)) << name;
    const ClassResult read = store.read(two_labs());
    for (const judge::CaseResult& result : step_in(read.students.at(0), "1.1").cases) {
      if (result.name != "same") continue;
      ASSERT_EQ(result.message, std::string(20'000, result.mistake.at(0)));
    }
  }
}

}  // namespace
}  // namespace texel::store
