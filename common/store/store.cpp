// SPDX-License-Identifier: MIT
#include "store/store.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <mutex>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "sqlite.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;
using Facts = std::map<std::string, std::string>;

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
  command TEXT NOT NULL, picture TEXT NOT NULL, reference TEXT NOT NULL, status TEXT NOT NULL DEFAULT 'failed',
  judged TEXT NOT NULL DEFAULT 'together',
  PRIMARY KEY (student, lab, name)) STRICT, WITHOUT ROWID;
CREATE TABLE overrides (
  student TEXT, step TEXT, score REAL NOT NULL CHECK (score BETWEEN 0 AND 1), reason TEXT NOT NULL,
  PRIMARY KEY (student, step)) STRICT, WITHOUT ROWID;
CREATE TABLE earlier (
  student TEXT, step TEXT, score REAL NOT NULL, PRIMARY KEY (student, step)) STRICT, WITHOUT ROWID;
)";

/// From version 1, which told an untouched step by the beginning of its message.
constexpr const char* kFromVersion1 = R"(
ALTER TABLE cases ADD COLUMN status TEXT NOT NULL DEFAULT 'failed';
UPDATE cases SET status = 'untouched' WHERE message LIKE 'This step is still as the starter has it. %';
UPDATE cases SET status = 'passed' WHERE passed;
ALTER TABLE cases DROP COLUMN passed;
ALTER TABLE cases DROP COLUMN unit;
)";

/// From version 2, which judged no step alone.
constexpr const char* kFromVersion2 = "ALTER TABLE cases ADD COLUMN judged TEXT NOT NULL DEFAULT 'together';";

struct Table {
  const char* name;
  const char* order;              ///< by its key
  std::string_view of_step = {};  ///< what a row is of a student's step; else it is part of the student
};

/// All tables; a student's come after the students.
constexpr Table kTables[] = {
    {"facts", "1"},
    {"students", "1"},
    {"ignored", "1, 2"},
    {"logs", "1, 2"},
    {"notes", "1, 2, 3"},
    {"incidents", "1, 2"},
    {"cases", "1, 2, 3"},
    {"overrides", "1, 2", "the override"},
    {"earlier", "1, 2", "the earlier score"},
};

Statement rows_of(const Connection& connection, const Table& table) {
  return {connection, fmt::format("SELECT * FROM {} ORDER BY {}", table.name, table.order)};
}

/// A row on one line.
std::string line_of(const Table& table, const Statement& row) {
  std::string line = table.name;
  for (int i = 0; i < row.columns(); ++i) {
    line += '\t';
    for (const char c : row.as_text(i)) {
      if (c == '\\' || c == '\t' || c == '\n') line += '\\';
      line += c == '\t' ? 't' : c == '\n' ? 'n' : c;
    }
  }
  return line + '\n';
}

/// All lines of a store but its facts, those together that are about the same.
std::map<std::string, std::string> lines_by_matter(const Connection& connection) {
  std::map<std::string, std::string> lines;
  for (const Table& table : kTables) {
    if (table.name == std::string_view("facts")) continue;
    for (Statement row = rows_of(connection, table); row.next();) {
      std::string matter = "the student " + row.as_text(0);
      if (!table.of_step.empty())
        matter = fmt::format("{} of step {} of {}", table.of_step, row.as_text(1), matter);
      lines[matter] += line_of(table, row);
    }
  }
  return lines;
}

/// The place of so many values in a statement.
std::string marks(int count) {
  return fmt::format("({})", fmt::join(std::vector<const char*>(static_cast<std::size_t>(count), "?"), ", "));
}

Facts facts_of(const Connection& connection) {
  Facts facts;
  std::string name, value;
  for (Statement row(connection, "SELECT name, value FROM facts"); row.next();) {
    row >> name >> value;
    facts[name] = value;
  }
  return facts;
}

bool is_empty(const Connection& connection) {
  return facts_of(connection).empty() && !Statement(connection, "SELECT 1 FROM students").next();
}

/// Throws Error (exit 2) that names the first fact in which two stores differ.
void expect_equal_facts(const Connection& ours, const Connection& theirs) {
  const Facts a = facts_of(ours), b = facts_of(theirs);
  const auto value_in = [](const Facts& facts, const std::string& name) {
    const auto found = facts.find(name);
    return found == facts.end() ? std::string("not given") : fmt::format("'{}'", found->second);
  };
  Facts all = a;
  all.insert(b.begin(), b.end());
  for (const auto& [name, value] : all)
    if (value_in(a, name) != value_in(b, name))
      throw Error::usage(fmt::format("{} and {} were graded differently: {} is {} in one and {} in the other",
                                     ours.file(), theirs.file(), name, value_in(a, name), value_in(b, name)),
                         "merge only stores with the same course, labs, seed and renderer");
}

void write_notes(const Connection& connection, const std::string& student, const std::string& lab,
                 const std::vector<std::string>& notes) {
  Statement(connection, "DELETE FROM notes WHERE student = ? AND lab = ?", student, lab).run();
  int place = 0;
  for (const std::string& note : notes)
    Statement(connection, "INSERT INTO notes VALUES (?, ?, ?, ?)", student, lab, ++place, note).run();
}

void write_incident(const Connection& connection, const std::string& student, const std::string& lab,
                    const std::string& text) {
  if (text.empty())
    Statement(connection, "DELETE FROM incidents WHERE student = ? AND lab = ?", student, lab).run();
  else
    Statement(connection, "INSERT OR REPLACE INTO incidents VALUES (?, ?, ?)", student, lab, text).run();
}

std::vector<Override> read_overrides(const Connection& connection) {
  std::vector<Override> overrides;
  for (Statement row(connection, "SELECT student, step, score, reason FROM overrides ORDER BY student, step");
       row.next();) {
    Override& one = overrides.emplace_back();
    row >> one.student >> one.step >> one.score >> one.reason;
  }
  return overrides;
}

/// Whether a step's score was found since the last beginning, and is not only missing yet.
bool is_judged(const StudentResult& student, const StepResult& step) {
  return !step.cases.empty() || !student.fault.empty() || !step.overridden.empty();
}

/// The students without their labs, by id.
std::map<std::string, StudentResult> read_students(const Connection& connection) {
  std::map<std::string, StudentResult> students;
  std::string id;
  for (Statement row(connection, "SELECT student, name, number, fault FROM students"); row.next();) {
    row >> id;
    StudentResult& student = students[id];
    student.id = id;
    row >> student.name >> student.number >> student.fault;
  }
  for (Statement row(connection, "SELECT student, path, reason FROM ignored ORDER BY student, place");
       row.next();) {
    row >> id;
    Ignored& ignored = students.at(id).ignored.emplace_back();
    row >> ignored.path >> ignored.reason;
  }
  for (Statement row(connection, "SELECT student, file, text FROM logs ORDER BY student, file");
       row.next();) {
    row >> id;
    CompilerLog& log = students.at(id).logs.emplace_back();
    row >> log.file >> log.text;
  }
  std::string lab, text;
  for (Statement row(connection, "SELECT student, lab, text FROM incidents ORDER BY student, lab");
       row.next();) {
    row >> id >> lab >> text;
    std::string& incident = students.at(id).incident;
    if (!incident.empty()) incident += '\n';
    if (!lab.empty()) incident += lab + ": ";
    incident += text;
  }
  return students;
}

course::View view_called(const std::string& name) {
  const std::optional<course::View> view = course::find_view(name);
  if (!view) throw Error::failed(fmt::format("the store has a case of the view '{}'", name));
  return *view;
}

constexpr const char* kCaseColumns =
    "lab, name, step, view, hidden, score, error, bound, message, mistake, mistake_says, command, picture, "
    "reference, status, judged";

std::vector<CaseResult> read_cases(const Connection& connection, const std::string& student) {
  std::vector<CaseResult> cases;
  for (Statement row(connection, fmt::format("SELECT {} FROM cases WHERE student = ?", kCaseColumns),
                     student);
       row.next();) {
    CaseResult& one = cases.emplace_back();
    std::string view, status, judged;
    row >> one.lab >> one.name >> one.step >> view >> one.hidden >> one.score >> one.error >> one.limit >>
        one.message >> one.mistake >> one.mistake_says >> one.command >> one.picture >> one.reference >>
        status >> judged;
    one.view = view_called(view), one.status = case_status_of(status), one.judged = judged_of(judged);
  }
  return cases;
}

void apply(const Override& override, StudentResult& student) {
  for (LabResult& lab : student.labs)
    for (StepResult& step : lab.steps) {
      if (step.id != override.step) continue;
      step.score = override.score;
      step.overridden = override.reason;
      if (step.score >= 1)
        step.status = Status::passed;
      else if (step.status == Status::passed)
        step.status = Status::failed;
    }
}

ClassResult read_class_result(const Connection& connection, const std::vector<course::Lab>& labs) {
  ClassResult result;
  result.facts = facts_of(connection);
  std::map<std::string, StudentResult> students = read_students(connection);
  for (auto& [id, student] : students) {
    student.labs = lab_results(labs, read_cases(connection, id));
    std::string note;
    for (LabResult& lab : student.labs)
      for (Statement row(connection, "SELECT text FROM notes WHERE student = ? AND lab = ? ORDER BY place",
                         id, lab.lab.folder);
           row.next();) {
        row >> note;
        lab.notes.push_back(note);
      }
  }
  for (const Override& override : read_overrides(connection))
    if (const auto found = students.find(override.student); found != students.end())
      apply(override, found->second);

  std::map<std::pair<std::string, std::string>, double> earlier;
  std::string id, step_id;
  for (Statement row(connection, "SELECT student, step, score FROM earlier"); row.next();) {
    row >> id >> step_id;
    row >> earlier[{id, step_id}];
  }
  for (auto& [student_id, student] : students) {
    for (const LabResult& lab : student.labs)
      for (const StepResult& step : lab.steps) {
        const auto before = earlier.find({student_id, step.id});
        if (before != earlier.end() && before->second != step.score && is_judged(student, step))
          result.changes.push_back({student_id, step.id, before->second, step.score});
      }
    result.students.push_back(std::move(student));
  }
  return result;
}

/// Makes the tables in a new file. Throws Error (exit 3) for a file of another program or a later version.
void prepare(const Connection& connection) {
  const auto number = [&](const char* sql) {
    int value = 0;
    Statement row(connection, sql);
    row.next();
    row >> value;
    return value;
  };
  const auto version = [&] { return number("PRAGMA user_version"); };
  const bool is_new = version() == 0 && number("SELECT count(*) FROM sqlite_master") == 0;
  if (!is_new && number("PRAGMA application_id") != kApplication) connection.fail(SQLITE_NOTADB);
  if (version() > kVersion)
    throw Error::failed(fmt::format("the store has version {}, newer than {}", version(), kVersion),
                        {connection.file()}, "use the program that made it, or a newer one");

  // FULL waits for the disk at every case, so that no result is lost with the power; with NORMAL the last
  // ones would be. Measured: 5 ms a case, a minute for 200 students with 60 cases each (NORMAL: 0.3 ms a
  // case).
  connection.use_write_ahead_log();
  connection.run("PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON");
  if (version() == kVersion) return;
  Transaction transaction(connection, Transaction::Kind::writes);
  // Unless another program has just done so.
  if (version() == 0)
    connection.run(fmt::format("{} PRAGMA application_id = {}; PRAGMA user_version = {}", kSchema,
                               kApplication, kVersion));
  if (version() == 1) connection.run(fmt::format("{} PRAGMA user_version = 2", kFromVersion1));
  if (version() == 2) connection.run(fmt::format("{} PRAGMA user_version = {}", kFromVersion2, kVersion));
  transaction.commit();
}

}  // namespace

struct Store::Database {
  explicit Database(const fs::path& file) : connection(file.string()) { prepare(connection); }

  Connection connection;
  std::mutex mutex;
};

Store::Store(const fs::path& file) : database_(std::make_unique<Database>(file)) {}
Store::~Store() = default;
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;

Facts Store::facts() const {
  const std::lock_guard lock(database_->mutex);
  return facts_of(database_->connection);
}

void Store::put_facts(const Facts& facts) {
  const std::lock_guard lock(database_->mutex);
  const Connection& connection = database_->connection;
  Transaction transaction(connection, Transaction::Kind::writes);
  connection.run("DELETE FROM facts");
  for (const auto& [name, value] : facts)
    Statement(connection, "INSERT INTO facts VALUES (?, ?)", name, value).run();
  transaction.commit();
}

void Store::begin_anew(const std::vector<course::Lab>& labs) {
  const std::lock_guard lock(database_->mutex);
  const Connection& connection = database_->connection;
  Transaction transaction(connection, Transaction::Kind::writes);
  for (const StudentResult& student : read_class_result(connection, labs).students)
    for (const LabResult& lab : student.labs)
      for (const StepResult& step : lab.steps)
        if (is_judged(student, step))
          Statement(connection, "INSERT OR REPLACE INTO earlier VALUES (?, ?, ?)", student.id, step.id,
                    step.score)
              .run();
  connection.run("DELETE FROM students");
  transaction.commit();
}

void Store::put_student(const StudentResult& student, const std::string& digest) {
  const std::lock_guard lock(database_->mutex);
  const Connection& connection = database_->connection;
  Transaction transaction(connection, Transaction::Kind::writes);
  if (!digest.empty())
    Statement(connection, "DELETE FROM students WHERE student = ? AND digest <> ?", student.id, digest).run();
  Statement(connection,
            "INSERT INTO students VALUES (?, ?, ?, ?, ?) ON CONFLICT DO UPDATE SET "
            "name = excluded.name, number = excluded.number, fault = excluded.fault",
            student.id, digest, student.name, student.number, student.fault)
      .run();

  Statement(connection, "DELETE FROM ignored WHERE student = ?", student.id).run();
  int place = 0;
  for (const Ignored& ignored : student.ignored)
    Statement(connection, "INSERT INTO ignored VALUES (?, ?, ?, ?)", student.id, ++place, ignored.path,
              ignored.reason)
        .run();
  for (const LabResult& lab : student.labs) write_notes(connection, student.id, lab.lab.folder, lab.notes);
  write_incident(connection, student.id, "", student.incident);
  transaction.commit();
}

void Store::expect_student(const StudentResult& student) {
  const std::lock_guard lock(database_->mutex);
  Statement(database_->connection, "INSERT OR IGNORE INTO students VALUES (?, '', ?, ?, '')", student.id,
            student.name, student.number)
      .run();
}

void Store::put_log(const std::string& student, const CompilerLog& log) {
  const std::lock_guard lock(database_->mutex);
  Statement(database_->connection,
            "INSERT INTO logs VALUES (?1, ?2, ?3) ON CONFLICT DO UPDATE SET text = excluded.text", student,
            log.file, log.text)
      .run();
}

void Store::put_notes(const std::string& student, const std::string& lab,
                      const std::vector<std::string>& notes) {
  const std::lock_guard lock(database_->mutex);
  Transaction transaction(database_->connection, Transaction::Kind::writes);
  write_notes(database_->connection, student, lab, notes);
  transaction.commit();
}

void Store::put(const std::string& student, const CaseResult& result) {
  const std::lock_guard lock(database_->mutex);
  Statement(database_->connection,
            fmt::format("INSERT OR REPLACE INTO cases (student, {}) VALUES {}", kCaseColumns, marks(17)),
            student, result.lab, result.name, result.step, std::string(name_of(result.view)), result.hidden,
            result.score, result.error, result.limit, result.message, result.mistake, result.mistake_says,
            result.command, result.picture, result.reference, std::string(name_of(result.status)),
            std::string(name_of(result.judged)))
      .run();
}

void Store::put_incident(const std::string& student, const std::string& lab, const std::string& text) {
  const std::lock_guard lock(database_->mutex);
  write_incident(database_->connection, student, lab, text);
}

std::set<std::string> Store::judged(const std::string& student) const {
  const std::lock_guard lock(database_->mutex);
  std::set<std::string> cases;
  std::string name;
  for (Statement row(database_->connection, "SELECT lab || '/' || name FROM cases WHERE student = ?",
                     student);
       row.next();) {
    row >> name;
    cases.insert(name);
  }
  return cases;
}

void Store::put_override(const Override& override) {
  const std::string what =
      fmt::format("the override of step {} of the student {}", override.step, override.student);
  if (!(override.score >= 0 && override.score <= 1))
    throw Error::usage(fmt::format("{} has the score {}", what, override.score), "give one from 0 to 1");
  if (override.reason.empty()) throw Error::usage(what + " has no reason", "add --reason with the reason");
  const std::lock_guard lock(database_->mutex);
  Statement(database_->connection, "INSERT OR REPLACE INTO overrides VALUES (?, ?, ?, ?)", override.student,
            override.step, override.score, override.reason)
      .run();
}

void Store::drop_override(const std::string& student, const std::string& step) {
  const std::lock_guard lock(database_->mutex);
  Statement(database_->connection, "DELETE FROM overrides WHERE student = ? AND step = ?", student, step)
      .run();
}

std::vector<Override> Store::overrides() const {
  const std::lock_guard lock(database_->mutex);
  return read_overrides(database_->connection);
}

ClassResult Store::read(const std::vector<course::Lab>& labs) const {
  const std::lock_guard lock(database_->mutex);
  // Other programs may write meanwhile: the rows are those of one moment.
  const Transaction transaction(database_->connection, Transaction::Kind::reads);
  return read_class_result(database_->connection, labs);
}

std::string Store::dump() const {
  const std::lock_guard lock(database_->mutex);
  const Transaction transaction(database_->connection, Transaction::Kind::reads);
  std::string text;
  for (const Table& table : kTables)
    for (Statement row = rows_of(database_->connection, table); row.next();) text += line_of(table, row);
  return text;
}

void Store::merge(const Store& other) {
  std::error_code gone;
  if (this == &other ||
      fs::equivalent(database_->connection.file(), other.database_->connection.file(), gone))
    return;
  const std::scoped_lock lock(database_->mutex, other.database_->mutex);
  const Connection& to = database_->connection;
  const Connection& from = other.database_->connection;
  const Transaction reading(from, Transaction::Kind::reads);
  Transaction writing(to, Transaction::Kind::writes);

  if (!is_empty(to) && !is_empty(from)) expect_equal_facts(to, from);
  const auto ours = lines_by_matter(to);
  for (const auto& [matter, theirs] : lines_by_matter(from))
    if (const auto found = ours.find(matter); found != ours.end() && found->second != theirs)
      throw Error::usage(fmt::format("{} and {} disagree about {}", to.file(), from.file(), matter),
                         "leave one of them out, or grade this student again");

  for (const Table& table : kTables) {
    Statement row = rows_of(from, table);
    // What both have is the same.
    Statement copy(to, fmt::format("INSERT OR IGNORE INTO {} VALUES {}", table.name, marks(row.columns())));
    while (row.next()) {
      copy.bind_row(row);
      copy.run();
    }
  }
  writing.commit();
}

}  // namespace texel::grade
