// SPDX-License-Identifier: MIT
// Programs run as a user runs them.
#pragma once
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <string>

namespace texel::test {

/// What a command left: its exit code (128 and more when a signal ended it) and what it printed.
struct Result {
  int exit_code = -1;
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

inline std::string read_all(std::FILE* file) {
  std::string text;
  std::array<char, 4096> block;
  while (const std::size_t got = std::fread(block.data(), 1, block.size(), file))
    text.append(block.data(), got);
  return text;
}

/// Runs a line of shell; "2>&1" at its end sends both streams to `output`.
inline Result shell(const std::string& command) {
  Result result;
  // The child's errors go to an unnamed file: of two pipes one could fill up while the other is read.
  std::FILE* errors = std::tmpfile();
  const int own_errors = ::dup(STDERR_FILENO);
  if (errors == nullptr || own_errors < 0) return result;
  ::dup2(::fileno(errors), STDERR_FILENO);
  std::FILE* pipe = ::popen(command.c_str(), "r");
  ::dup2(own_errors, STDERR_FILENO);
  ::close(own_errors);
  if (pipe != nullptr) {
    result.output = read_all(pipe);
    const int status = ::pclose(pipe);
    result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  std::rewind(errors);
  result.errors = read_all(errors);
  std::fclose(errors);
  return result;
}

/// A word that the shell takes as it is.
inline std::string shell_word(const std::string& word) {
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace texel::test
