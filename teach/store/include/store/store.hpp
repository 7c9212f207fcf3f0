// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "store/class_results.hpp"

/// The grades of a class, in one SQLite file that survives the grader's sudden end.
namespace texel::store {

class Connection;

/// Everything is committed as it comes, in SQLite's write-ahead log, and waits for the disk. So what was put
/// is there after a sudden end of the program or of the machine; of what was being put, either the old is
/// there or the new. While a store is open, and after a sudden end, the files beside it that end in -wal and
/// -shm belong to it: who copies it then copies them too.
///
/// Times are not kept: two runs over the same class give the same rows. Members may be called by many
/// threads, and many processes may open one file. Each throws Error (exit 3) with the file and a remedy, and
/// leaves what was there: for a full disk, a file or folder without write permission, a file that is no
/// store, is damaged, or is of another version, and one that another program holds for half a minute.
class Store {
 public:
  /// Opens the store, or makes one when there is none.
  explicit Store(const std::filesystem::path& file);
  ~Store();

  /// What the results depend on (course, seed, labs, renderer), by name.
  [[nodiscard]] std::map<std::string, std::string> facts() const;
  /// Replaces all facts.
  void put_facts(const std::map<std::string, std::string>& facts);

  /// Begins anew: the steps' scores as they are now become the earlier ones with which `changes` compares;
  /// results and students are forgotten, overrides stay. A step that was not judged since the last beginning
  /// keeps its earlier score, so that a regrade that was cut short can begin once more.
  void begin_anew(const std::vector<course::Lab>& labs);

  /// Makes a student known who is to be graded, unless the store has the student already: whom an unfinished
  /// run did not come to is then not missing from it.
  void expect_student(const StudentResult& student);

  /// What is known of a student besides the cases; comes before anything else of the student, who is unknown
  /// until then (exit 3). Replaces what was there: names, fault, ignored files, the incident, and the notes
  /// of each lab in `student.labs`. Logs, and the notes and incidents of other labs, stay, so that a run that
  /// is taken up again keeps them. `digest` is a fingerprint of the submission's files: when it is another
  /// than before, the student's results, logs, notes and incidents go. Where the files could not be read it
  /// is "": nothing goes, so that a fault of the machine costs no score.
  void put_student(const StudentResult& student, const std::string& digest);
  /// What the compiler said of one of the student's files, in place of what it said of it before.
  void put_log(const std::string& student, const CompilerLog& log);
  /// One lab's notes of a student, in place of those that were there.
  void put_notes(const std::string& student, const std::string& lab, const std::vector<std::string>& notes);
  /// One case of a student; replaces an earlier result of the same case. Its score must lie in 0 to 1.
  void put(const std::string& student, const judge::CaseResult& result);
  /// A fault of the grader or machine with one student's lab. It is no result; "" takes it back.
  void put_incident(const std::string& student, const std::string& lab, const std::string& text);

  /// The cases that need not be judged again, as "05_normal_map/decode".
  [[nodiscard]] std::set<std::string> judged(const std::string& student) const;

  /// Sets a step's score; the student may be unknown yet. Throws Error (exit 2) for a score outside 0 to 1
  /// and for no reason.
  void put_override(const Override& override);
  void drop_override(const std::string& student, const std::string& step);

  /// All results, as steps, labs and students. The labs say which steps there are. Overrides are applied: one
  /// of 1 makes the step passed, a lower one makes a passed step failed. What is said of a step follows from
  /// the pictures all the same. A student's incidents are one text, a line for each, with its lab's name
  /// before it. Changes are those of steps that were judged anew.
  [[nodiscard]] ClassResult read(const std::vector<course::Lab>& labs) const;

  /// Takes over all of another store, or nothing. Throws Error (exit 2) when its facts are others (a store
  /// without facts and students has none to differ in), and when both say different things of the same
  /// student.
  void merge(const Store& other);

 private:
  /// Runs one statement with its values.
  template <class... Values>
  void run(const std::string& sql, const Values&... values);

  std::unique_ptr<Connection> connection_;
};

}  // namespace texel::store
