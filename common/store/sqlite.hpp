// SPDX-License-Identifier: MIT
// SQLite's handles with an end, and its codes as errors that say what to do. Only what the store needs.
#pragma once
#include <sqlite3.h>

#include <memory>
#include <string>
#include <string_view>

namespace texel::grade {

/// A database file that is open. Not for two threads at once.
class Connection {
 public:
  /// Opens a file, or makes it. Nothing is written to it yet. Throws as `fail` does.
  explicit Connection(const std::string& file);

  /// Runs statements that give no rows, one after the other.
  void run(const std::string& sql) const;

  /// Keeps a log beside the file, so that readers and a writer do not wait for each other. A new file is
  /// changed to that by one program alone, and for this SQLite does not wait of itself.
  void use_write_ahead_log() const;

  /// Throws Error (exit 3) for a code of SQLite's.
  [[noreturn]] void fail(int code) const;

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] sqlite3* get() const { return handle_.get(); }

 private:
  std::string file_;
  std::unique_ptr<sqlite3, decltype(&sqlite3_close)> handle_;
};

/// A statement with its values in place of the question marks, row by row:
///
///     Statement rows(connection, "SELECT name, value FROM facts WHERE name = ?", name);
///     while (rows.next()) rows >> name >> value;
class Statement {
 public:
  template <typename... Values>
  Statement(const Connection& connection, const std::string& sql, const Values&... values)
      : connection_(connection) {
    prepare(sql);
    bind(values...);
  }

  /// New values, for another run.
  template <typename... Values>
  void bind(const Values&... values) {
    sqlite3_reset(handle_.get());
    [[maybe_unused]] int place = 0;  // there may be no values
    (bind_one(++place, values), ...);
  }
  /// The values of another statement's row.
  void bind_row(const Statement& row);

  /// Goes to the next row; whether there is one.
  bool next();
  /// For a statement without rows.
  void run() {
    while (next()) continue;
  }

  /// The row's next column. NaN where a number is missing.
  Statement& operator>>(std::string& value);
  Statement& operator>>(double& value);
  Statement& operator>>(int& value);
  Statement& operator>>(bool& value);

  [[nodiscard]] int columns() const { return sqlite3_column_count(handle_.get()); }
  /// Any column as text; a number in the fewest digits that give it back, "nan" where it is missing.
  [[nodiscard]] std::string as_text(int column) const;

 private:
  void prepare(const std::string& sql);
  void bind_one(int place, std::string_view value);
  void bind_one(int place, double value);
  void bind_one(int place, int value);
  [[nodiscard]] double real(int column) const;
  void check(int code) const;

  const Connection& connection_;
  std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)> handle_{nullptr, &sqlite3_finalize};
  int column_ = 0;
};

/// All that is done until its commit, or nothing.
class Transaction {
 public:
  enum class Kind { reads, writes };

  Transaction(const Connection& connection, Kind kind);
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;
  void commit();

 private:
  const Connection& connection_;
};

}  // namespace texel::grade
