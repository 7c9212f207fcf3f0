// SPDX-License-Identifier: MIT
#pragma once
#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>

#include <limits>
#include <mutex>
#include <string>

namespace texel::store {

/// A database file that is open, for any number of threads.
class Connection {
 public:
  /// Opens a file, or makes it. Nothing is written to it yet. Throws Error (exit 3).
  explicit Connection(std::string file);

  /// What `work` gives for the database, which no other thread uses meanwhile. Throws Error (exit 3), with
  /// the file and a remedy, for what SQLite refuses.
  template <class Work>
  auto use(const Work& work) {
    const std::lock_guard lock(mutex_);
    try {
      return work(database_);
    } catch (const SQLite::Exception& error) {
      fail(error.getErrorCode(), error.what());
    }
  }

  /// The same in one transaction: all of the work is done, or nothing.
  template <class Work>
  void change(const Work& work) {
    use([&](SQLite::Database& database) {
      SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
      work(database);
      transaction.commit();
    });
  }

  /// Keeps a log beside the file, so that readers and a writer do not wait for each other. A new file is
  /// changed to that by one program alone, and for this SQLite does not wait of itself.
  void use_write_ahead_log();

  /// Throws the error of a code of SQLite's. `says`: its own words for it.
  [[noreturn]] void fail(int code, const std::string& says) const;

  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  std::string file_;
  SQLite::Database database_;
  std::mutex mutex_;
};

/// A statement with its values in place of the question marks, row by row:
///
///     Query rows(database, "SELECT name, value FROM facts WHERE name = ?", name);
///     while (rows.next()) facts.push_back({rows.text(), rows.text()});
class Query : public SQLite::Statement {
 public:
  template <typename... Values>
  Query(const SQLite::Database& database, const std::string& sql, const Values&... values)
      : Statement(database, sql) {
    SQLite::bind(*this, values...);
  }

  /// Goes to the next row; whether there is one.
  bool next() {
    column_ = 0;
    return executeStep();
  }

  /// The row's next column.
  std::string text() { return getColumn(column_++).getString(); }
  /// The row's next column; NaN where there is no number.
  double number() {
    const SQLite::Column column = getColumn(column_++);
    return column.isNull() ? std::numeric_limits<double>::quiet_NaN() : column.getDouble();
  }

 private:
  int column_ = 0;
};

}  // namespace texel::store
