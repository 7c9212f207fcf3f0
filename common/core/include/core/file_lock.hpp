// SPDX-License-Identifier: MIT
#pragma once
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/error.hpp"

namespace texel {

/// Keeps other processes out as long as it lives. The file stays.
class FileLock {
 public:
  /// Waits for its turn; with `at_once` throws Error (exit 3) when another has it.
  explicit FileLock(const std::filesystem::path& file, bool at_once = false)
      : file_(::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644)) {
    if (file_ < 0)
      throw Error::failed(fmt::format("cannot be opened: {}", std::strerror(errno)), {file.string()},
                          "name a writable folder");
    if (::flock(file_, LOCK_EX | (at_once ? LOCK_NB : 0)) != 0) {
      ::close(file_);
      throw Error::failed("another process works here", {file.string()}, "wait for its end");
    }
  }
  ~FileLock() { ::close(file_); }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int file_;
};

}  // namespace texel
