// SPDX-License-Identifier: MIT
#include "store/store.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>
#include <utility>

#include "connection.hpp"
#include "core/error.hpp"

namespace texel::store {
namespace {

namespace fs = std::filesystem;
using Facts = std::map<std::string, std::string>;
using SQLite::Database;
using SQLite::Transaction;

constexpr int kApplication = 0x5458474c;  ///< "TXGL": tells a store from SQLite files of other programs
constexpr int kVersion = 3;

/// What falls with its student refers to one, so that no row is left alone.
constexpr const char* kSchema = R"(
CREATE TABLE facts (name TEXT PRIMARY KEY, value TEXT NOT NULL) STRICT, WITHOUT ROWID;
CREATE TABLE students (
  student TEXT PRIMARY KEY, digest TEXT NOT NULL, name TEXT NOT NULL, number TEXT NOT NULL,
  fault TEXT NOT NULL) STRICT, WITHOUT ROWID;
CREATE TABLE ignored (
  student TEXT REFERENCES students ON DELETE CASCADE, place INTEGER, path TEXT NOT NULL, reason TEXT NOT NULL,
  PRIMARY KEY (student, place)) STRICT, WITHOUT ROWID;
CREATE TABLE logs (
  student TEXT REFERENCES students ON DELETE CASCADE, file TEXT, text TEXT NOT NULL,
  PRIMARY KEY (student, file)) STRICT, WITHOUT ROWID;
CREATE TABLE notes (
  student TEXT REFERENCES students ON DELETE CASCADE, lab TEXT, place INTEGER, text TEXT NOT NULL,
  PRIMARY KEY (student, lab, place)) STRICT, WITHOUT ROWID;
-- The lab "" has the incident of the student as a whole.
CREATE TABLE incidents (
  student TEXT REFERENCES students ON DELETE CASCADE, lab TEXT, text TEXT NOT NULL,
  PRIMARY KEY (student, lab)) STRICT, WITHOUT ROWID;
-- The error is NULL where nothing could be compared.
CREATE TABLE cases (
  student TEXT REFERENCES students ON DELETE CASCADE, lab TEXT, name TEXT, step TEXT NOT NULL,
  view TEXT NOT NULL, hidden INTEGER NOT NULL, score REAL NOT NULL CHECK (score BETWEEN 0 AND 1), error REAL,
  bound REAL NOT NULL, message TEXT NOT NULL, mistake TEXT NOT NULL, mistake_says TEXT NOT NULL,
  command TEXT NOT NULL, picture TEXT NOT NULL, reference TEXT NOT NULL, status TEXT NOT NULL,
  judged TEXT NOT NULL,
  PRIMARY KEY (student, lab, name)) STRICT, WITHOUT ROWID;
CREATE TABLE overrides (
  student TEXT, step TEXT, score REAL NOT NULL CHECK (score BETWEEN 0 AND 1), reason TEXT NOT NULL,
  PRIMARY KEY (student, step)) STRICT, WITHOUT ROWID;
CREATE TABLE earlier (
  student TEXT, step TEXT, score REAL NOT NULL, PRIMARY KEY (student, step)) STRICT, WITHOUT ROWID;
)";

/// All tables; a student's come after the students.
constexpr std::array kTables = {"facts",     "students", "ignored",   "logs",   "notes",
                                "incidents", "cases",    "overrides", "earlier"};

Facts facts_of(Database& database) {
  Facts facts;
  for (Query row(database, "SELECT name, value FROM facts"); row.next();)
    facts.insert({row.text(), row.text()});
  return facts;
}

/// Of the database `main` and the copy `theirs` of another store: the first fact that is not the same in
/// both, with its values as people read them. A store without facts and students has none to differ in.
constexpr const char* kOtherFact = R"(
SELECT name, coalesce('''' || a.value || '''', 'not given'), coalesce('''' || b.value || '''', 'not given')
FROM (SELECT name FROM main.facts UNION SELECT name FROM theirs.facts)
  LEFT JOIN main.facts a USING (name) LEFT JOIN theirs.facts b USING (name)
WHERE a.value IS NOT b.value
  AND EXISTS (SELECT name FROM main.facts UNION SELECT student FROM main.students)
  AND EXISTS (SELECT name FROM theirs.facts UNION SELECT student FROM theirs.students)
ORDER BY name)";

/// What is in both stores, but not the same: where one of them alone has a row of `table`, as `name` and the
/// student say it. `key` finds a row of the table `whole` for each that there is.
std::string different(const std::string& table, const char* whole, const char* key, const std::string& name) {
  return fmt::format(R"(
SELECT {3} || student AS matter
FROM (SELECT * FROM main.{0} UNION SELECT * FROM theirs.{0}
  EXCEPT SELECT * FROM (SELECT * FROM main.{0} INTERSECT SELECT * FROM theirs.{0}))
WHERE ({2}) IN (SELECT {2} FROM main.{1} INTERSECT SELECT {2} FROM theirs.{1}))",
                     table, whole, key, name);
}

/// Throws Error (exit 2) that names the first thing in which the database and the copy `theirs` differ.
void expect_no_difference(Database& database, const std::string& ours, const std::string& theirs) {
  if (Query fact(database, kOtherFact); fact.next()) {
    const std::string name = fact.text(), our_value = fact.text(), their_value = fact.text();
    throw Error::usage(fmt::format("{} and {} were graded differently: {} is {} in one and {} in the other",
                                   ours, theirs, name, our_value, their_value),
                       "merge only stores with the same course, labs, seed and renderer");
  }
  constexpr const char* of_step = "'the {} of step ' || step || ' of the student '";
  std::vector<std::string> all = {
      different("overrides", "overrides", "student, step", fmt::format(of_step, "override")),
      different("earlier", "earlier", "student, step", fmt::format(of_step, "earlier score"))};
  for (const char* table : {"students", "ignored", "logs", "notes", "incidents", "cases"})
    all.push_back(different(table, "students", "student", "'the student '"));
  if (Query first(database, fmt::format("{} ORDER BY matter", fmt::join(all, " UNION ALL "))); first.next())
    throw Error::usage(fmt::format("{} and {} disagree about {}", ours, theirs, first.text()),
                       "leave one of them out, or grade this student again");
}

/// The place of so many values in a statement.
std::string marks(std::size_t count) {
  return fmt::format("({})", fmt::join(std::vector<const char*>(count, "?"), ", "));
}

void write_notes(Database& database, const std::string& student, const std::string& lab,
                 const std::vector<std::string>& notes) {
  Query(database, "DELETE FROM notes WHERE student = ? AND lab = ?", student, lab).exec();
  int place = 0;
  for (const std::string& note : notes)
    Query(database, "INSERT INTO notes VALUES (?, ?, ?, ?)", student, lab, ++place, note).exec();
}

void write_incident(Database& database, const std::string& student, const std::string& lab,
                    const std::string& text) {
  if (text.empty())
    Query(database, "DELETE FROM incidents WHERE student = ? AND lab = ?", student, lab).exec();
  else
    Query(database, "INSERT OR REPLACE INTO incidents VALUES (?, ?, ?)", student, lab, text).exec();
}

/// Whether a step's score was found since the last beginning, and is not only missing yet.
bool is_judged(const StudentResult& student, const judge::StepResult& step) {
  return !step.cases.empty() || !student.fault.empty() || !step.overridden.empty();
}

/// The students without their labs, by id.
std::map<std::string, StudentResult> read_students(Database& database) {
  std::map<std::string, StudentResult> students;
  for (Query row(database, "SELECT student, name, number, fault FROM students"); row.next();) {
    const std::string id = row.text();
    StudentResult& student = students[id];
    student.id = id, student.name = row.text(), student.number = row.text(), student.fault = row.text();
  }
  for (Query row(database, "SELECT student, path, reason FROM ignored ORDER BY student, place"); row.next();)
    students.at(row.text()).ignored.push_back({row.text(), row.text()});
  for (Query row(database, "SELECT student, file, text FROM logs ORDER BY student, file"); row.next();)
    students.at(row.text()).logs.push_back({row.text(), row.text()});
  for (Query row(database, "SELECT student, lab, text FROM incidents ORDER BY student, lab"); row.next();) {
    std::string& incident = students.at(row.text()).incident;
    const std::string lab = row.text();
    if (!incident.empty()) incident += '\n';
    if (!lab.empty()) incident += lab + ": ";
    incident += row.text();
  }
  return students;
}

course::View view_called(const std::string& name) {
  const std::optional<course::View> view = course::find_view(name);
  if (!view) throw Error::failed(fmt::format("the store has a case of the view '{}'", name));
  return *view;
}

judge::Judged judged_called(const std::string& name) {
  using enum judge::Judged;
  for (const judge::Judged judged : {together, alone, markers_lost})
    if (name == name_of(judged)) return judged;
  throw Error::failed(fmt::format("the store has a case that is judged '{}'", name));
}

constexpr const char* kCaseColumns =
    "lab, name, step, view, hidden, score, error, bound, message, mistake, mistake_says, command, picture, "
    "reference, status, judged";

std::vector<judge::CaseResult> read_cases(Database& database, const std::string& student) {
  std::vector<judge::CaseResult> cases;
  for (Query row(database, fmt::format("SELECT {} FROM cases WHERE student = ?", kCaseColumns), student);
       row.next();) {
    judge::CaseResult& one = cases.emplace_back();
    one.lab = row.text(), one.name = row.text(), one.step = row.text();
    one.view = view_called(row.text()), one.hidden = row.number() != 0;
    one.score = row.number(), one.error = row.number(), one.limit = row.number();
    one.message = row.text(), one.mistake = row.text(), one.mistake_says = row.text();
    one.command = row.text(), one.picture = row.text(), one.reference = row.text();
    one.status = judge::status_called(row.text()), one.judged = judged_called(row.text());
  }
  return cases;
}

void apply(const Override& override, StudentResult& student) {
  for (judge::LabResult& lab : student.labs)
    for (judge::StepResult& step : lab.steps) {
      if (step.id != override.step) continue;
      step.score = override.score;
      step.overridden = override.reason;
      if (step.score >= 1)
        step.status = judge::Status::passed;
      else if (step.status == judge::Status::passed)
        step.status = judge::Status::failed;
    }
}

ClassResult read_class_result(Database& database, const std::vector<course::Lab>& labs) {
  ClassResult result;
  result.facts = facts_of(database);
  std::map<std::string, StudentResult> students = read_students(database);
  for (auto& [id, student] : students) {
    student.labs = judge::lab_results(labs, read_cases(database, id));
    name_spoilers(student.labs);
    for (judge::LabResult& lab : student.labs)
      for (Query row(database, "SELECT text FROM notes WHERE student = ? AND lab = ? ORDER BY place", id,
                     lab.lab.folder);
           row.next();)
        lab.notes.push_back(row.text());
  }
  for (Query row(database, "SELECT student, step, score, reason FROM overrides"); row.next();) {
    const Override override{row.text(), row.text(), row.number(), row.text()};
    if (const auto found = students.find(override.student); found != students.end())
      apply(override, found->second);
  }
  std::map<std::pair<std::string, std::string>, double> earlier;  // by student and step
  for (Query row(database, "SELECT student, step, score FROM earlier"); row.next();)
    earlier.insert({{row.text(), row.text()}, row.number()});
  for (auto& [student_id, student] : students) {
    for (const judge::LabResult& lab : student.labs)
      for (const judge::StepResult& step : lab.steps) {
        const auto before = earlier.find({student_id, step.id});
        if (before != earlier.end() && before->second != step.score && is_judged(student, step))
          result.changes.push_back({student_id, step.id, before->second, step.score});
      }
    result.students.push_back(std::move(student));
  }
  return result;
}

/// Makes the tables in a new file. Throws Error (exit 3) for a file of another program or another version.
void prepare(Connection& connection) {
  const auto number = [&](const char* sql) {
    return connection.use([&](Database& database) { return database.execAndGet(sql).getInt(); });
  };
  const auto version = [&] { return number("PRAGMA user_version"); };
  // Another program may make the tables between two of these questions.
  const bool is_new = version() == 0 && number("SELECT count(*) FROM sqlite_master") == 0;
  if (!is_new && number("PRAGMA application_id") != kApplication) connection.fail(SQLITE_NOTADB, "");
  if (!is_new && version() != kVersion)
    throw Error::failed(
        fmt::format("the store has version {}, and this program writes version {}", version(), kVersion),
        {connection.file()}, "use the program that made it, or grade again into a new folder");

  // FULL waits for the disk at every case, so that no result is lost with the power; with NORMAL the last
  // ones would be. Measured: 5 ms a case, a minute for 200 students with 60 cases each (NORMAL: 0.3 ms a
  // case).
  connection.use_write_ahead_log();
  connection.use(
      [](Database& database) { database.exec("PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON"); });
  if (!is_new) return;
  connection.change([](Database& database) {
    if (database.execAndGet("PRAGMA user_version").getInt() == 0)
      database.exec(fmt::format("{} PRAGMA application_id = {}; PRAGMA user_version = {}", kSchema,
                                kApplication, kVersion));
  });
}

}  // namespace

const char* name_of(judge::Judged judged) {
  constexpr std::array kNames = {"together", "alone", "markers lost"};
  return kNames.at(static_cast<std::size_t>(judged));
}

bool is_any(const judge::StepResult& step, judge::Judged judged) {
  return std::ranges::find(step.cases, judged, &judge::CaseResult::judged) != step.cases.end();
}

void name_spoilers(std::vector<judge::LabResult>& labs) {
  for (judge::LabResult& lab : labs)
    for (judge::StepResult& step : lab.steps) {
      if (!is_any(step, judge::Judged::alone)) continue;
      for (const judge::StepResult& other : lab.steps) {
        const bool is_needed = std::ranges::find(step.needs, other.id) != step.needs.end();
        if (&other != &step && other.status == judge::Status::failed && (is_needed || !other.is_untouched()))
          step.spoilt_by.push_back(other.id);
      }
    }
}

Store::Store(const fs::path& file) : connection_(std::make_unique<Connection>(file.string())) {
  prepare(*connection_);
}

template <class... Values>
void Store::run(const std::string& sql, const Values&... values) {
  connection_->use([&](Database& database) { Query(database, sql, values...).exec(); });
}

Store::~Store() = default;

Facts Store::facts() const {
  return connection_->use(facts_of);
}

void Store::put_facts(const Facts& facts) {
  connection_->change([&](Database& database) {
    database.exec("DELETE FROM facts");
    for (const auto& [name, value] : facts)
      Query(database, "INSERT INTO facts VALUES (?, ?)", name, value).exec();
  });
}

void Store::begin_anew(const std::vector<course::Lab>& labs) {
  connection_->change([&](Database& database) {
    for (const StudentResult& student : read_class_result(database, labs).students)
      for (const judge::LabResult& lab : student.labs)
        for (const judge::StepResult& step : lab.steps)
          if (is_judged(student, step))
            Query(database, "INSERT OR REPLACE INTO earlier VALUES (?, ?, ?)", student.id, step.id,
                  step.score)
                .exec();
    database.exec("DELETE FROM students");
  });
}

void Store::put_student(const StudentResult& student, const std::string& digest) {
  connection_->change([&](Database& database) {
    if (!digest.empty())
      Query(database, "DELETE FROM students WHERE student = ? AND digest <> ?", student.id, digest).exec();
    Query(database,
          "INSERT INTO students VALUES (?, ?, ?, ?, ?) ON CONFLICT DO UPDATE SET "
          "name = excluded.name, number = excluded.number, fault = excluded.fault",
          student.id, digest, student.name, student.number, student.fault)
        .exec();
    Query(database, "DELETE FROM ignored WHERE student = ?", student.id).exec();
    int place = 0;
    for (const Ignored& ignored : student.ignored)
      Query(database, "INSERT INTO ignored VALUES (?, ?, ?, ?)", student.id, ++place, ignored.path,
            ignored.reason)
          .exec();
    for (const judge::LabResult& lab : student.labs)
      write_notes(database, student.id, lab.lab.folder, lab.notes);
    write_incident(database, student.id, "", student.incident);
  });
}

void Store::expect_student(const StudentResult& student) {
  run("INSERT OR IGNORE INTO students VALUES (?, '', ?, ?, '')", student.id, student.name, student.number);
}

void Store::put_log(const std::string& student, const CompilerLog& log) {
  run("INSERT INTO logs VALUES (?1, ?2, ?3) ON CONFLICT DO UPDATE SET text = excluded.text", student,
      log.file, log.text);
}

void Store::put_notes(const std::string& student, const std::string& lab,
                      const std::vector<std::string>& notes) {
  connection_->change([&](Database& database) { write_notes(database, student, lab, notes); });
}

void Store::put(const std::string& student, const judge::CaseResult& result) {
  run(fmt::format("INSERT OR REPLACE INTO cases (student, {}) VALUES {}", kCaseColumns, marks(17)), student,
      result.lab, result.name, result.step, name_of(result.view), result.hidden, result.score, result.error,
      result.limit, result.message, result.mistake, result.mistake_says, result.command, result.picture,
      result.reference, name_of(result.status), name_of(result.judged));
}

void Store::put_incident(const std::string& student, const std::string& lab, const std::string& text) {
  connection_->use([&](Database& database) { write_incident(database, student, lab, text); });
}

std::set<std::string> Store::judged(const std::string& student) const {
  return connection_->use([&](Database& database) {
    std::set<std::string> cases;
    for (Query row(database, "SELECT lab || '/' || name FROM cases WHERE student = ?", student); row.next();)
      cases.insert(row.text());
    return cases;
  });
}

void Store::put_override(const Override& override) {
  const std::string what =
      fmt::format("the override of step {} of the student {}", override.step, override.student);
  if (!(override.score >= 0 && override.score <= 1))
    throw Error::usage(fmt::format("{} has the score {}", what, override.score), "give one from 0 to 1");
  if (override.reason.empty()) throw Error::usage(what + " has no reason", "add --reason with the reason");
  run("INSERT OR REPLACE INTO overrides VALUES (?, ?, ?, ?)", override.student, override.step, override.score,
      override.reason);
}

void Store::drop_override(const std::string& student, const std::string& step) {
  run("DELETE FROM overrides WHERE student = ? AND step = ?", student, step);
}

ClassResult Store::read(const std::vector<course::Lab>& labs) const {
  return connection_->use([&](Database& database) {
    // Other programs may write meanwhile: the rows are those of one moment.
    const Transaction transaction(database);
    return read_class_result(database, labs);
  });
}

void Store::merge(const Store& other) {
  const std::string &ours = connection_->file(), &theirs = other.connection_->file();
  std::error_code gone;
  if (this == &other || fs::equivalent(ours, theirs, gone)) return;
  Store joined(ours);  // closes what it attaches
  joined.connection_->use([&](Database& database) {
    // What cannot be read is the other's fault. The copy in memory is of one moment, and locks nobody out.
    other.connection_->use([&](Database&) {
      Query(database, "ATTACH ? AS other", theirs).exec();
      database.exec("PRAGMA temp_store = MEMORY; ATTACH ':memory:' AS theirs");
      Transaction transaction(database);
      for (const char* table : kTables)
        database.exec(fmt::format("CREATE TABLE theirs.{0} AS SELECT * FROM other.{0}", table));
      transaction.commit();
      database.exec("DETACH other");
    });
  });
  joined.connection_->change([&](Database& database) {
    expect_no_difference(database, ours, theirs);
    for (const char* table : kTables)  // what both have is the same
      database.exec(fmt::format("INSERT OR IGNORE INTO main.{0} SELECT * FROM theirs.{0}", table));
  });
}

}  // namespace texel::store
