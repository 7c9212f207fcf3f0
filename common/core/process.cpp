// SPDX-License-Identifier: MIT
#include "core/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "core/error.hpp"

namespace texel {
namespace {

Error not_started(const std::vector<std::string>& command, int error) {
  return Error::failed(fmt::format("cannot be started: {}", std::strerror(error)), {command.front()});
}

pid_t start(const std::vector<std::string>& command, int output, int errors) {
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  if (errors != STDERR_FILENO) ::posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw not_started(command, error);
  return child;
}

int exit_code_of(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

/// Closed at the end of its scope.
struct Pipe {
  explicit Pipe(const std::vector<std::string>& command) {
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw not_started(command, errno);
  }
  ~Pipe() {
    ::close(ends[0]);
    close_writing();
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close_writing() {
    if (ends[1] >= 0) ::close(ends[1]);
    ends[1] = -1;
  }
  std::array<int, 2> ends{};
};

}  // namespace

Ran run_program(const std::vector<std::string>& command, bool with_errors) {
  Pipe pipe(command);
  const pid_t child = start(command, pipe.ends[1], with_errors ? pipe.ends[1] : STDERR_FILENO);
  pipe.close_writing();
  Ran ran;
  std::array<char, 4096> block{};
  for (ssize_t got = 0;
       (got = ::read(pipe.ends[0], block.data(), block.size())) > 0 || (got < 0 && errno == EINTR);)
    if (got > 0) ran.output.append(block.data(), static_cast<std::size_t>(got));
  ran.exit_code = exit_code_of(child);
  return ran;
}

int run_into(const std::vector<std::string>& command, int output, int errors) {
  return exit_code_of(start(command, output, errors));
}

}  // namespace texel
