// SPDX-License-Identifier: MIT
#include "core/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>
#include <limits>

#include "core/error.hpp"
#include "core/files.hpp"
#include "core/stopwatch.hpp"

namespace texel {
namespace {

/// A file in memory that a child writes.
class Stream {
 public:
  explicit Stream(const std::string& program) : file_(::memfd_create("stream", MFD_CLOEXEC)) {
    if (!file_.is_open()) throw Error::failed("cannot be started: no memory for what it prints", {program});
  }
  [[nodiscard]] int get() const { return file_.get(); }
  [[nodiscard]] std::uint64_t bytes() const {
    return static_cast<std::uint64_t>(::lseek(get(), 0, SEEK_END));
  }
  [[nodiscard]] std::string first(std::size_t most) const {
    std::string text(std::min<std::size_t>(most, bytes()), '\0');
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::pread(get(), text.data(), text.size(), 0))));
    return text;
  }

 private:
  Descriptor file_;
};

}  // namespace

int run_into(const std::vector<std::string>& command, int output, int errors) {
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
  if (error != 0)
    throw Error::failed(fmt::format("cannot be started: {}", std::strerror(error)), {command.front()});
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

Ran run_program(const std::vector<std::string>& command, bool with_errors) {
  const Stream output(command.front());
  const int exit_code = run_into(command, output.get(), with_errors ? output.get() : STDERR_FILENO);
  return {exit_code, output.first(std::numeric_limits<std::size_t>::max())};
}

std::map<std::string, std::string> environment_of(const Confines& confines) {
  std::map<std::string, std::string> all = {{"PATH", "/usr/bin:/bin"}, {"HOME", "/tmp"}, {"LANG", "C.UTF-8"}};
  for (const auto& [name, value] : confines.environment) all[name] = value;
  return all;
}

const char* name_of(Limit limit) {
  constexpr const char* names[] = {"", "wall time", "processor time", "memory", "disk", "output"};
  return names[static_cast<int>(limit)];
}

std::vector<std::string> prlimit_words(const ProcessLimits& limits) {
  const auto cpu = static_cast<std::uint64_t>(std::ceil(limits.cpu_seconds));
  return {"prlimit", fmt::format("--as={}", limits.address_space),
          // The soft limit sends a signal of its own, the hard one kills a program that ignores it.
          fmt::format("--cpu={}:{}", cpu, cpu + 1), fmt::format("--fsize={}", limits.disk),
          fmt::format("--nofile={}", limits.open_files), "--core=0"};
}

Outcome run_plainly(const Confines& confines, const std::vector<std::string>& command) {
  const ProcessLimits& limits = confines.limits;
  std::vector<std::string> words = {"env", "-i", "-C", confines.working_folder.string()};
  const auto append = [&](const std::vector<std::string>& more) {
    words.insert(words.end(), more.begin(), more.end());
  };
  for (const auto& [name, value] : environment_of(confines)) words.push_back(name + "=" + value);
  append({"timeout", "--signal=KILL", fmt::format("{}", limits.wall_seconds)});
  append(prlimit_words(limits));
  append({"--"});
  append(command);

  const Stream output(command.front()), errors(command.front());
  const Stopwatch stopwatch;
  Outcome outcome;
  outcome.exit_code = run_into(words, output.get(), errors.get());
  outcome.wall_seconds = stopwatch.milliseconds() / 1000;
  if (outcome.exit_code > 128 && outcome.exit_code < 128 + NSIG) outcome.signal = outcome.exit_code - 128;
  if (outcome.signal == SIGKILL && outcome.wall_seconds >= limits.wall_seconds) outcome.limit = Limit::wall;
  if (outcome.signal == SIGXCPU) outcome.limit = Limit::cpu;
  if (outcome.signal == SIGXFSZ) outcome.limit = Limit::disk;
  outcome.output = output.first(limits.kept_output), outcome.errors = errors.first(limits.kept_output);
  outcome.output_bytes = output.bytes(), outcome.error_bytes = errors.bytes();
  if (outcome.output_bytes + outcome.error_bytes > limits.output ||
      std::max(outcome.output_bytes, outcome.error_bytes) >= limits.disk)
    outcome.limit = Limit::output;
  return outcome;
}

}  // namespace texel
