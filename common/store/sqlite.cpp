// SPDX-License-Identifier: MIT
#include "sqlite.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>

#include "core/error.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;

/// How long to wait for another program, in ms: much longer than any of our transactions takes.
constexpr int kPatience = 30'000;

/// SQLite's code without what it adds, and with the system's reason where it only says that a file could not
/// be opened or read.
int plain_code(int code, int reason) {
  const int plain = code & 0xff;
  if (plain != SQLITE_CANTOPEN && plain != SQLITE_IOERR) return plain;
  if (reason == ENOSPC || reason == EDQUOT) return SQLITE_FULL;
  if (reason == EROFS || reason == EACCES || reason == EPERM) return SQLITE_READONLY;
  return plain;
}

}  // namespace

Connection::Connection(const std::string& file) : file_(file), handle_(nullptr, &sqlite3_close) {
  sqlite3* opened = nullptr;
  const int code = sqlite3_open_v2(file.c_str(), &opened,
                                   SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX, nullptr);
  handle_.reset(opened);
  if (code != SQLITE_OK) fail(code);
  sqlite3_extended_result_codes(opened, 1);
  sqlite3_busy_timeout(opened, kPatience);
  if (sqlite3_db_readonly(opened, "main") == 1) fail(SQLITE_READONLY);
}

void Connection::run(const std::string& sql) const {
  const int code = sqlite3_exec(get(), sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code);
}

void Connection::use_write_ahead_log() const {
  constexpr int pause = 5;  // ms
  int code = SQLITE_BUSY;
  for (int waited = 0; (code & 0xff) == SQLITE_BUSY && waited <= kPatience; waited += pause) {
    if (waited > 0) sqlite3_sleep(pause);
    code = sqlite3_exec(get(), "PRAGMA journal_mode = WAL", nullptr, nullptr, nullptr);
  }
  if (code != SQLITE_OK) fail(code);
}

void Connection::fail(int code) const {
  const auto error = [&](const std::string& what, const char* remedy) {
    return Error::failed(what, {file_}, remedy);
  };
  const int reason = sqlite3_system_errno(get());
  int plain = plain_code(code, reason);
  if (plain == SQLITE_CANTOPEN) {
    const fs::path path(file_), parent = path.has_parent_path() ? path.parent_path() : ".";
    std::error_code unknown;
    if (fs::is_directory(path, unknown)) throw error("is a folder, not a store of grades", "name a file");
    if (!fs::is_directory(parent, unknown)) throw error("its folder does not exist", "make it first");
    // SQLite opened it once more for reading, and the reason is that it is not there.
    if (::access(parent.c_str(), W_OK) != 0) plain = SQLITE_READONLY;
  }
  switch (plain) {
    case SQLITE_FULL:
      throw error("the disk is full", "free some space and continue: earlier results are kept");
    case SQLITE_READONLY:
    case SQLITE_PERM:
      throw error("the store or its folder cannot be written",
                  "get write permission for both, or choose another folder");
    case SQLITE_CANTOPEN:
      throw error("it or a file beside it cannot be opened",
                  "check that you own these files and the disk has free space");
    case SQLITE_NOTADB:
      throw error("is not a store of grades", "name another file, or move this one away");
    case SQLITE_CORRUPT:
      throw error("the store is damaged", "replace it by a backup, or move it away and grade again");
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw error("another program uses the store", "try again when it has ended");
    case SQLITE_CONSTRAINT:
      throw error(fmt::format("a row breaks the store's rules: {}", sqlite3_errmsg(get())),
                  "this is a bug of the grader");
    default:
      throw error(fmt::format("SQLite says: {}{}", sqlite3_errmsg(get()),
                              reason == 0 ? "" : fmt::format(" ({})", std::strerror(reason))),
                  "check the disk, then try again");
  }
}

void Statement::prepare(const std::string& sql) {
  sqlite3_stmt* prepared = nullptr;
  check(sqlite3_prepare_v2(connection_.get(), sql.c_str(), -1, &prepared, nullptr));
  handle_.reset(prepared);
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) connection_.fail(code);
}

void Statement::bind_one(int place, std::string_view value) {
  check(sqlite3_bind_text(handle_.get(), place, value.data(), static_cast<int>(value.size()),
                          SQLITE_TRANSIENT));
}

void Statement::bind_one(int place, double value) {
  check(sqlite3_bind_double(handle_.get(), place, value));  // a NaN becomes NULL
}

void Statement::bind_one(int place, int value) {
  check(sqlite3_bind_int(handle_.get(), place, value));
}

void Statement::bind_row(const Statement& row) {
  sqlite3_reset(handle_.get());
  for (int i = 0; i < row.columns(); ++i)
    check(sqlite3_bind_value(handle_.get(), i + 1, sqlite3_column_value(row.handle_.get(), i)));
}

bool Statement::next() {
  column_ = 0;
  const int code = sqlite3_step(handle_.get());
  if (code != SQLITE_ROW && code != SQLITE_DONE) connection_.fail(code);
  return code == SQLITE_ROW;
}

std::string Statement::as_text(int column) const {
  if (sqlite3_column_type(handle_.get(), column) != SQLITE_TEXT) return fmt::format("{}", real(column));
  const auto* text = reinterpret_cast<const char*>(sqlite3_column_text(handle_.get(), column));
  return {text, static_cast<std::size_t>(sqlite3_column_bytes(handle_.get(), column))};
}

double Statement::real(int column) const {
  if (sqlite3_column_type(handle_.get(), column) == SQLITE_NULL)
    return std::numeric_limits<double>::quiet_NaN();
  return sqlite3_column_double(handle_.get(), column);
}

Statement& Statement::operator>>(std::string& value) {
  value = as_text(column_++);
  return *this;
}

Statement& Statement::operator>>(double& value) {
  value = real(column_++);
  return *this;
}

Statement& Statement::operator>>(int& value) {
  value = sqlite3_column_int(handle_.get(), column_++);
  return *this;
}

Statement& Statement::operator>>(bool& value) {
  int number = 0;
  *this >> number;
  value = number != 0;
  return *this;
}

Transaction::Transaction(const Connection& connection, Kind kind) : connection_(connection) {
  // A writer takes its turn at once: one that first reads could be told at its first write to begin again.
  connection_.run(kind == Kind::writes ? "BEGIN IMMEDIATE" : "BEGIN");
}

Transaction::~Transaction() {
  // Some errors have rolled it back already.
  if (sqlite3_get_autocommit(connection_.get()) == 0)
    sqlite3_exec(connection_.get(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void Transaction::commit() {
  connection_.run("COMMIT");
}

}  // namespace texel::grade
