// SPDX-License-Identifier: MIT
#include "connection.hpp"

#include <fmt/format.h>
#include <sqlite3.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/error.hpp"

namespace texel::store {
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

/// What people read of a code of SQLite's.
struct Fault {
  int code;
  const char *says, *remedy;
};
constexpr Fault kFaults[] = {
    {SQLITE_FULL, "the disk is full", "free some space and continue: earlier results are kept"},
    {SQLITE_READONLY, "the store or its folder cannot be written",
     "get write permission for both, or choose another folder"},
    {SQLITE_CANTOPEN, "it or a file beside it cannot be opened",
     "check that you own these files and the disk has free space"},
    {SQLITE_NOTADB, "is not a store of grades", "name another file, or move this one away"},
    {SQLITE_CORRUPT, "the store is damaged", "replace it by a backup, or move it away and grade again"},
    {SQLITE_BUSY, "another program uses the store", "try again when it has ended"}};

/// Throws Error (exit 3) for a code of SQLite's. `reason`: the system's, or 0.
[[noreturn]] void fail_of(const fs::path& file, int code, int reason, const std::string& says) {
  const auto error = [&](const std::string& what, const char* remedy) {
    return Error::failed(what, {file.string()}, remedy);
  };
  int plain = plain_code(code, reason);
  if (plain == SQLITE_CANTOPEN) {
    const fs::path parent = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code unknown;
    if (fs::is_directory(file, unknown)) throw error("is a folder, not a store of grades", "name a file");
    if (!fs::is_directory(parent, unknown)) throw error("its folder does not exist", "make it first");
    // SQLite opened it once more for reading, and the reason is that it is not there.
    if (::access(parent.c_str(), W_OK) != 0 ||
        (fs::exists(file, unknown) && ::access(file.c_str(), R_OK | W_OK) != 0))
      plain = SQLITE_READONLY;
  }
  for (const Fault& fault : kFaults)
    if (fault.code == plain) throw error(fault.says, fault.remedy);
  if (plain == SQLITE_CONSTRAINT)
    throw error(fmt::format("a row breaks the store's rules: {}", says), "this is a bug of the grader");
  const std::string of_system = reason == 0 ? "" : fmt::format(" ({})", std::strerror(reason));
  throw error(fmt::format("SQLite says: {}{}", says, of_system), "check the disk, then try again");
}

SQLite::Database opened(const std::string& file) {
  try {
    return {file, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE | SQLite::OPEN_NOMUTEX, kPatience};
  } catch (const SQLite::Exception& error) {
    fail_of(file, error.getErrorCode(), 0, error.what());
  }
}

}  // namespace

Connection::Connection(std::string file) : file_(std::move(file)), database_(opened(file_)) {
  if (sqlite3_db_readonly(database_.getHandle(), "main") == 1) fail(SQLITE_READONLY, "");
}

void Connection::use_write_ahead_log() {
  constexpr int pause = 5;  // ms
  int code = SQLITE_BUSY;
  for (int waited = 0; (code & 0xff) == SQLITE_BUSY && waited <= kPatience; waited += pause) {
    if (waited > 0) sqlite3_sleep(pause);
    code = database_.tryExec("PRAGMA journal_mode = WAL");
  }
  if (code != SQLITE_OK) fail(code, database_.getErrorMsg());
}

void Connection::fail(int code, const std::string& says) const {
  fail_of(file_, code, sqlite3_system_errno(database_.getHandle()), says);
}

}  // namespace texel::store
