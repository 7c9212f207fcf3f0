// SPDX-License-Identifier: MIT
#include "process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <sys/wait.h>
#include <unistd.h>

extern "C" {
#include <sys/pidfd.h>  // has no linkage of its own before glibc 2.37
}

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>

#include "another_user.hpp"
#include "copy.hpp"
#include "core/stopwatch.hpp"

namespace texel::sandbox {
namespace {

constexpr int start_milliseconds = 30'000;  // bubblewrap needs some ten
constexpr double end_seconds = 30;          // from the kill until the kernel has taken the sandbox down
constexpr int watch_milliseconds = 10;      // how often memory and disk are looked at
constexpr std::size_t most_names = 100'000;
constexpr std::size_t block_size = 65536;  // what a pipe holds

Error error_of_system(const std::string& doing) {
  return sandbox_error(fmt::format("cannot {}: {}", doing, std::strerror(errno)));
}

struct Pipe {
  Descriptor read_end, write_end;
  Pipe() {
    int ends[2] = {-1, -1};
    if (::pipe2(ends, O_CLOEXEC) != 0) throw error_of_system("make a pipe");
    read_end = Descriptor(ends[0]);
    write_end = Descriptor(ends[1]);
  }
};

/// Of all memory that the kernel counts. Files are in memory too; what processes show is held to
/// `limits.memory` by looking. 128 MiB more are for pipes (64 MiB, see `sandbox_test`), page tables (2 MiB
/// for each GiB of a process) and stacks in the kernel.
std::uint64_t most_memory(const Confines& confines) {
  const ProcessLimits& limits = confines.limits;
  return limits.memory + limits.disk * (confines.writable.size() + 1) + (128U << 20U);
}

/// A file in memory that a child can read.
Descriptor file_of(const std::string& bytes) {
  Descriptor file(::memfd_create("sandbox", MFD_CLOEXEC));
  if (!file.is_open() ||
      ::write(file.get(), bytes.data(), bytes.size()) != static_cast<ssize_t>(bytes.size()) ||
      ::lseek(file.get(), 0, SEEK_SET) != 0)
    throw error_of_system("hand over the arguments");
  return file;
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> all;
  for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
  all.push_back(nullptr);
  return all;
}

/// Starts a program in a process group of its own. It gets copies of `descriptors` as its 0, 1, 2, … and no
/// other.
pid_t spawn(const Launch& launch, const std::vector<int>& descriptors) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  const int count = static_cast<int>(descriptors.size());
  // First out of each other's way, then each to its place.
  std::vector<Descriptor> copies;
  for (int i = 0; i < count; ++i) {
    copies.emplace_back(::fcntl(descriptors[static_cast<std::size_t>(i)], F_DUPFD_CLOEXEC, count));
    ::posix_spawn_file_actions_adddup2(&actions, copies.back().get(), i);
  }
  ::posix_spawn_file_actions_addclosefrom_np(&actions, count);
  sigset_t none;
  sigset_t all;
  ::sigemptyset(&none);
  ::sigfillset(&all);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setflags(&attributes,
                             POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);
  pid_t child = -1;
  const int error = ::posix_spawnp(&child, launch.command[0].c_str(), &actions, &attributes,
                                   pointers(launch.command).data(), pointers(launch.environment).data());
  ::posix_spawn_file_actions_destroy(&actions);
  ::posix_spawnattr_destroy(&attributes);
  if (error == ENOENT && launch.command[0] == "bwrap")
    throw sandbox_error("there is no bwrap", "install bubblewrap, or use --unsafe for code that you trust");
  if (error != 0)
    throw sandbox_error(fmt::format("cannot start {}: {}", launch.command[0], std::strerror(error)));
  return child;
}

/// The number behind a word of /proc/…/status, or 0.
std::uint64_t number_behind(const std::string& key, const std::string& status) {
  const std::size_t found = status.find(key);
  return found == status.npos ? 0 : std::strtoull(status.c_str() + found + key.size(), nullptr, 10);
}

/// What lies in the folders of a disk that others use too: bytes, or more than any limit for too many files.
std::uint64_t size_of(const std::filesystem::path& folder, std::uint64_t most_files) {
  std::error_code error;  // files come and go
  std::uint64_t size = 0, files = 0;
  for (std::filesystem::recursive_directory_iterator it(folder, error), end; !error && it != end;
       it.increment(error)) {
    struct stat status {};
    if (::lstat(it->path().c_str(), &status) == 0) size += static_cast<std::uint64_t>(status.st_blocks) * 512;
    if (++files > most_files) return ~0ULL;
  }
  return size;
}

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

}  // namespace

Usage usage_of_all(const Descriptor& proc, unsigned user) {
  constexpr std::size_t longest = 4096;
  static const double ticks = static_cast<double>(::sysconf(_SC_CLK_TCK));
  Usage usage;
  for (const std::string& name : names_in(proc, most_names)) {
    if (name[0] < '1' || name[0] > '9') continue;
    const Descriptor process = open_in(proc, name);
    const std::string status = read_some(open_in(process, "status"), longest);
    if (user != 0 && number_behind("\nUid:", status) != user) continue;
    for (const char* key : {"\nRssAnon:", "\nRssShmem:"}) usage.memory += number_behind(key, status) * 1024;
    // proc(5): behind the name in brackets, which may hold anything, the 12th to 15th word are the times.
    const std::string stat = read_some(open_in(process, "stat"), longest);
    std::istringstream words(stat.substr(std::min(stat.rfind(')') + 1, stat.size())));
    std::string word;
    for (int i = 1; i <= 15 && words >> word; ++i) {
      if (i == 1 && word != "Z") ++usage.processes;
      if (i >= 12) usage.cpu_seconds += static_cast<double>(std::strtoull(word.c_str(), nullptr, 10)) / ticks;
    }
  }
  return usage;
}

Error sandbox_error(const std::string& what, const std::string& remedy) {
  return Error::failed("the sandbox failed: " + what, {}, remedy);
}

std::vector<std::string> first_process() {
  return {"/bin/sh", "-c",
          "printf r >&3; exec 3>&-; read -r go <&4 || exit 1; exec 4<&- 5<&- 6<&- 7>&-; \"$@\"; exit $?",
          "sh"};
}

Stream::Stream(Descriptor descriptor) : descriptor_(std::move(descriptor)) {
  ::fcntl(descriptor_.get(), F_SETFL, O_NONBLOCK);
}

void Stream::drain(std::size_t keep) {
  std::array<char, block_size> block;
  for (int i = 0; i < 64 && descriptor_.is_open(); ++i) {
    const ssize_t got = ::read(descriptor_.get(), block.data(), block.size());
    if (got < 0) return;
    if (got == 0) return descriptor_.close();
    const auto size = static_cast<std::size_t>(got);
    bytes_ += size;
    kept_.append(block.data(), std::min(size, keep - std::min(keep, kept_.size())));
  }
}

Process::Process(const Confines& confines, const Launch& launch)
    : confines_(confines), group_(most_memory(confines)), user_(launch.user) {
  try {
    if (user_ == 0)
      start_in_namespaces(launch);
    else
      start_as_another_user(launch);
  } catch (...) {
    if (child_ > 0) end();
    throw;
  }
}

void Process::take_streams(Descriptor output, Descriptor errors) {
  child_handle_ = Descriptor(::pidfd_open(child_, 0));
  if (!child_handle_.is_open()) throw error_of_system("watch a process");
  streams_.emplace_back(std::move(output));
  streams_.emplace_back(std::move(errors));
}

void Process::start_as_another_user(const Launch& launch) {
  const Descriptor nothing(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  proc_ = Descriptor(::open("/proc", O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  for (const std::filesystem::path& folder : confines_.writable)
    disks_.emplace_back(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
  Pipe output;
  Pipe errors;
  child_ = spawn_filtered(launch.command, launch.environment, launch.filter,
                          {nothing.get(), output.write_end.get(), errors.write_end.get()},
                          confines_.working_folder);
  if (child_ < 0) throw error_of_system("start a process");
  group_.take(child_);
  take_streams(std::move(output.read_end), std::move(errors.read_end));
}

void Process::start_in_namespaces(const Launch& launch) {
  const Descriptor nothing(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  const Descriptor arguments = file_of(launch.arguments);
  const Descriptor filter = file_of(launch.filter);
  Pipe output;
  Pipe errors;
  Pipe ready;
  Pipe go;
  Pipe info;
  child_ =
      spawn(launch, {nothing.get(), output.write_end.get(), errors.write_end.get(), ready.write_end.get(),
                     go.read_end.get(), arguments.get(), filter.get(), info.write_end.get()});
  go_ = std::move(go.write_end);
  for (Pipe* pipe : {&output, &errors, &ready, &info}) pipe->write_end.close();
  take_streams(std::move(output.read_end), std::move(errors.read_end));
  wait_until_ready(ready.read_end, info.read_end);
  open_inside();
  group_.take(first_);
  // While the other end is open here too, this cannot meet a closed pipe.
  if (::write(go_.get(), "\n", 1) != 1) throw error_of_system("start the program");
}

Process::~Process() {
  if (child_ > 0) end();
}

void Process::wait_until_ready(const Descriptor& ready, const Descriptor& info) {
  char byte = 0;
  pollfd waited{ready.get(), POLLIN, 0};
  int changed = 0;
  do {
    changed = ::poll(&waited, 1, start_milliseconds);
  } while (changed < 0 && errno == EINTR);
  // At the end of the file everybody who could have written is gone.
  if (changed != 1 || ::read(ready.get(), &byte, 1) != 1) {
    end();
    drain();
    throw sandbox_error(streams_[1].kept().empty() ? "it does not start" : streams_[1].kept(),
                        "allow this user to create namespaces, or use --unsafe for code that you trust");
  }
  std::array<char, 4096> text{};
  const ssize_t got = ::read(info.get(), text.data(), text.size() - 1);
  const char* const key = "\"child-pid\":";
  const char* found = got > 0 ? std::strstr(text.data(), key) : nullptr;
  first_ = found == nullptr ? -1 : static_cast<pid_t>(std::strtol(found + std::strlen(key), nullptr, 10));
  first_handle_ = Descriptor(first_ <= 0 ? -1 : ::pidfd_open(first_, 0));
  if (!first_handle_.is_open()) throw sandbox_error("bubblewrap does not report its process");
}

void Process::open_inside() {
  const auto open_folder = [&](const std::filesystem::path& folder) {
    const std::string path = fmt::format("/proc/{}/root{}", first_, folder.string());
    Descriptor opened(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (!opened.is_open()) throw error_of_system("look at " + folder.string() + " inside");
    return opened;
  };
  proc_ = open_folder("/proc");
  for (const std::filesystem::path& folder : confines_.writable) disks_.push_back(open_folder(folder));
  disks_.push_back(open_folder("/tmp"));
}

Outcome Process::watch() {
  const Stopwatch stopwatch;
  const auto seconds = [&] { return stopwatch.milliseconds() / 1000; };
  Outcome outcome;
  double stopped_at = 0;
  while (!has_ended()) {
    drain();
    if (outcome.limit != Limit::none) {
      if (seconds() - stopped_at > end_seconds) throw sandbox_error("a killed program does not end");
      continue;
    }
    const Usage usage = usage_of_all(proc_, user_);
    outcome.peak_memory = std::max(outcome.peak_memory, usage.memory);
    outcome.cpu_seconds = std::max(outcome.cpu_seconds, usage.cpu_seconds);
    outcome.limit = exceeded(seconds(), usage);
    if (outcome.limit == Limit::none) continue;
    stop();
    stopped_at = seconds();
  }
  outcome.wall_seconds = seconds();
  const Ended ended = end();
  drain();
  outcome.exit_code = ended.exit_code;
  if (ended.exit_code > 128 && ended.exit_code < 128 + NSIG) outcome.signal = ended.exit_code - 128;
  // The kernel forgets the times of a sandbox that was killed.
  outcome.cpu_seconds = std::max(outcome.cpu_seconds, ended.usage.cpu_seconds);
  outcome.peak_memory = std::max(outcome.peak_memory, ended.usage.memory);
  outcome.output = streams_[0].kept();
  outcome.errors = streams_[1].kept();
  outcome.output_bytes = streams_[0].bytes();
  outcome.error_bytes = streams_[1].bytes();
  if (outcome.limit == Limit::none) outcome.limit = limit_behind(outcome);
  return outcome;
}

Limit Process::exceeded(double seconds, const Usage& usage) const {
  const ProcessLimits& limits = confines_.limits;
  if (seconds > limits.wall_seconds) return Limit::wall;
  if (usage.cpu_seconds > limits.cpu_seconds) return Limit::cpu;
  if (usage.memory > limits.memory) return Limit::memory;
  if (is_disk_full()) return Limit::disk;
  if (streams_[0].bytes() + streams_[1].bytes() > limits.output) return Limit::output;
  return Limit::none;
}

Limit Process::limit_behind(const Outcome& outcome) const {
  if (group_.was_exceeded()) return Limit::memory;
  if (outcome.signal == SIGXCPU) return Limit::cpu;
  if (outcome.signal == SIGKILL && outcome.cpu_seconds > confines_.limits.cpu_seconds) return Limit::cpu;
  if (outcome.signal == SIGXFSZ) return Limit::disk;
  return exceeded(0, {});
}

bool Process::is_disk_full() const {
  if (user_ != 0)
    return std::any_of(confines_.writable.begin(), confines_.writable.end(), [&](const auto& folder) {
      return size_of(folder, confines_.limits.files) > confines_.limits.disk;
    });
  return std::any_of(disks_.begin(), disks_.end(), [&](const Descriptor& disk) {
    struct statfs status {};
    return ::fstatfs(disk.get(), &status) == 0 &&
           (status.f_bavail == 0 || status.f_files - status.f_ffree > confines_.limits.files);
  });
}

bool Process::has_ended() {
  std::array<pollfd, 3> waited{
      {{child_handle_.get(), POLLIN, 0}, {streams_[0].fd(), POLLIN, 0}, {streams_[1].fd(), POLLIN, 0}}};
  ::poll(waited.data(), waited.size(), watch_milliseconds);
  return waited[0].revents != 0;
}

void Process::drain() {
  for (Stream& stream : streams_) stream.drain(confines_.limits.kept_output);
}

void Process::stop() {
  if (user_ != 0) {
    kill_all_of(user_);
    return;
  }
  // bubblewrap itself ends when its first process has, and then with the times of all.
  ::pidfd_send_signal(first_handle_.get(), SIGKILL, nullptr, 0);
}

Process::Ended Process::end() {
  if (user_ == 0)
    ::kill(-child_, SIGKILL);
  else if (!kill_all_of(user_))
    throw sandbox_error("a killed program does not end");
  int status = 0;
  rusage usage{};
  while (::wait4(child_, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  child_ = -1;
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          {static_cast<std::uint64_t>(usage.ru_maxrss) * 1024,
           seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime)}};
}

bool Process::copy_writable(const std::vector<std::filesystem::path>& to) const {
  bool all = true;
  for (std::size_t i = 0; i < to.size(); ++i)
    all = copy_results(disks_[i], to[i], confines_.limits.disk) && all;
  return all;
}

}  // namespace texel::sandbox
