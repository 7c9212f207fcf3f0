// SPDX-License-Identifier: MIT
#include "processes.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstring>
#include <map>

#include "core/error.hpp"

namespace texel::tools {
namespace {

pid_t start(const Command& command) {
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  pid_t process = 0;
  const int error = ::posix_spawn(&process, arguments[0], nullptr, nullptr, arguments.data(), environ);
  if (error != 0)
    throw Error::failed(fmt::format("cannot be started: {}", std::strerror(error)), {command.front()},
                        "build it with ./run build");
  return process;
}

/// The processes that run, by their number in the list of commands.
class Running {
 public:
  ~Running() {
    for (const auto& [process, index] : processes_) ::waitpid(process, nullptr, 0);
  }
  Running() = default;
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  [[nodiscard]] std::size_t size() const { return processes_.size(); }
  void add(std::size_t index, const Command& command) { processes_[start(command)] = index; }

  /// The number of one that ended, and its status.
  std::pair<std::size_t, int> wait_for_one() {
    int status = 0;
    pid_t process = -1;
    do process = ::waitpid(-1, &status, 0);
    while (process < 0 && errno == EINTR);
    const auto found = processes_.find(process);
    if (found == processes_.end()) throw Error::failed("a started program was lost");
    const std::size_t index = found->second;
    processes_.erase(found);
    return {index, WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status)};
  }

 private:
  std::map<pid_t, std::size_t> processes_;
};

}  // namespace

void run_all(const std::vector<Command>& commands, int at_once,
             const std::function<void(std::size_t, int)>& ended) {
  Running running;
  std::size_t next = 0;
  while (next < commands.size() || running.size() > 0) {
    while (next < commands.size() && running.size() < static_cast<std::size_t>(at_once)) {
      running.add(next, commands[next]);
      ++next;
    }
    const auto [index, status] = running.wait_for_one();
    ended(index, status);
  }
}

}  // namespace texel::tools
