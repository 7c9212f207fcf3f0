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

Ran run_program(const std::vector<std::string>& command, bool with_errors) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
    throw Error::failed(fmt::format("cannot be started: {}", std::strerror(errno)), {command.front()});
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_adddup2(&actions, pipe[1], STDOUT_FILENO);
  if (with_errors) ::posix_spawn_file_actions_adddup2(&actions, pipe[1], STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(pipe[1]);
  Ran ran;
  if (error == 0) {
    std::array<char, 4096> block{};
    for (ssize_t got = 0;
         (got = ::read(pipe[0], block.data(), block.size())) > 0 || (got < 0 && errno == EINTR);)
      if (got > 0) ran.output.append(block.data(), static_cast<std::size_t>(got));
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    ran.exit_code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }
  ::close(pipe[0]);
  if (error != 0)
    throw Error::failed(fmt::format("cannot be started: {}", std::strerror(error)), {command.front()});
  return ran;
}

}  // namespace texel
