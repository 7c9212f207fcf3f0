// SPDX-License-Identifier: MIT
#include "process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/vfs.h>
#include <sys/wait.h>
#include <unistd.h>

extern "C" {
#include <sys/pidfd.h>  // has no linkage of its own before glibc 2.37
}

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <thread>

#include "core/stopwatch.hpp"

namespace texel::sandbox {
namespace {

constexpr int start_milliseconds = 30'000;  // bubblewrap needs some ten
constexpr double end_seconds = 30;          // from the kill until the kernel has taken the sandbox down
constexpr double idle_seconds = 30;         // without processor time: it waits for itself, or was stopped
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

/// The words as exec takes them.
std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> all;
  for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
  all.push_back(nullptr);
  return all;
}

/// Starts a program in a session of its own, without namespaces with the filter and no way to new rights. It
/// gets copies of `descriptors` as its 0, 1, 2, … and no other.
pid_t spawn(const Launch& launch, const std::filesystem::path& folder, const std::vector<int>& descriptors) {
  const std::vector<char*> words = pointers(launch.command), variables = pointers(launch.environment);
  std::string instructions = launch.filter;
  const sock_fprog filter{static_cast<unsigned short>(instructions.size() / sizeof(sock_filter)),
                          reinterpret_cast<sock_filter*>(instructions.data())};
  const int count = static_cast<int>(descriptors.size());
  std::vector<int> copies(descriptors);
  Pipe said;  // stays empty if the program starts
  copies.push_back(said.write_end.get());
  const pid_t child = ::fork();
  if (child < 0) throw error_of_system("start a process");
  if (child > 0) {
    said.write_end.close();
    int error = 0;
    ssize_t got = 0;
    while ((got = ::read(said.read_end.get(), &error, sizeof error)) < 0 && errno == EINTR) continue;
    if (got == 0) return child;
    ::waitpid(child, nullptr, 0);
    if (error == ENOENT && launch.command[0] == "bwrap")
      throw sandbox_error("there is no bwrap", "install bubblewrap, or use --unsafe for code that you trust");
    throw sandbox_error(fmt::format("cannot start {}: {}", launch.command[0], std::strerror(error)));
  }
  // Other threads held locks when the process was copied: from here on nothing that takes one.
  ::setsid();
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);
  // First out of each other's way, then each to its place. Behind them is the pipe that tells of an error.
  bool is_set = true;
  for (int& copy : copies) is_set = (copy = ::fcntl(copy, F_DUPFD_CLOEXEC, count + 1)) >= 0 && is_set;
  for (int i = 0; i < count; ++i) is_set = ::dup2(copies[static_cast<std::size_t>(i)], i) == i && is_set;
  is_set = ::dup3(copies.back(), count, O_CLOEXEC) == count && is_set;
  ::closefrom(count + 1);
  const bool is_confined =
      launch.user == 0 || (::chdir(folder.c_str()) == 0 && ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
                           ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter) == 0);
  if (is_set && is_confined) ::execvpe(words[0], words.data(), variables.data());
  const int error = errno;
  const bool is_told = ::write(count, &error, sizeof error) == sizeof error;
  ::_exit(is_told ? 1 : 2);
}

/// The number behind a word of a text, or 0.
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

Descriptor open_folder(const std::filesystem::path& folder, int flags = 0) {
  return Descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | flags));
}

/// Of the processes that a /proc shows, with those of their children that have ended: of one user, or of all.
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

/// Kills all processes of a user id, and waits until none is left. They cannot kill the killer first.
/// Whether all ended within half a minute.
bool kill_all_of(unsigned user) {
  for (int i = 0; i < 3000; ++i) {
    // The kernel asks for the sender's real or effective id, and for the receiver's real or saved one. So it
    // reaches all of the user's processes, and none of them reaches it.
    const pid_t killer = ::fork();
    if (killer == 0) {
      if (::syscall(SYS_setresuid, user + 1, user, user + 1) == 0) ::kill(-1, SIGKILL);
      ::_exit(0);
    }
    if (killer > 0) ::waitpid(killer, nullptr, 0);
    if (usage_of_all(open_folder("/proc"), user).processes == 0) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

}  // namespace

Error sandbox_error(const std::string& what, const std::string& remedy) {
  return Error::failed("the sandbox failed: " + what, {}, remedy);
}

Process::Process(const Confines& confines, const Launch& launch)
    : confines_(confines), group_(most_memory(confines)), user_(launch.user) {
  const Descriptor nothing(::open("/dev/null", O_RDONLY | O_CLOEXEC));
  Pipe output, errors;
  for (Pipe* pipe : {&output, &errors}) {
    ::fcntl(pipe->read_end.get(), F_SETFL, O_NONBLOCK);
    streams_.push_back({std::move(pipe->read_end)});
  }
  try {
    const std::vector<int> streams = {nothing.get(), output.write_end.get(), errors.write_end.get()};
    user_ == 0 ? start_in_namespaces(launch, streams) : start_as_another_user(launch, streams);
  } catch (...) {
    if (child_ > 0) end();
    throw;
  }
}

void Process::start(const Launch& launch, const std::vector<int>& descriptors) {
  child_ = spawn(launch, confines_.working_folder, descriptors);
  child_handle_ = Descriptor(::pidfd_open(child_, 0));
  if (!child_handle_.is_open()) throw error_of_system("watch a process");
}

void Process::start_as_another_user(const Launch& launch, const std::vector<int>& streams) {
  proc_ = open_folder("/proc");
  for (const std::filesystem::path& folder : confines_.writable)
    disks_.push_back(open_folder(folder, O_NOFOLLOW));
  start(launch, streams);
  group_.take(child_);
}

void Process::start_in_namespaces(const Launch& launch, std::vector<int> descriptors) {
  const Descriptor arguments = file_of(launch.arguments), filter = file_of(launch.filter);
  Pipe ready, go, info;
  descriptors.insert(descriptors.end(), {ready.write_end.get(), go.read_end.get(), arguments.get(),
                                         filter.get(), info.write_end.get()});
  start(launch, descriptors);
  for (Pipe* pipe : {&ready, &info}) pipe->write_end.close();
  const pid_t first = wait_until_ready(ready.read_end, info.read_end);
  const auto open_inside = [&](const std::filesystem::path& folder) {
    Descriptor opened = open_folder(fmt::format("/proc/{}/root{}", first, folder.string()));
    if (!opened.is_open()) throw error_of_system("look at " + folder.string() + " inside");
    return opened;
  };
  proc_ = open_inside("/proc");
  for (const std::filesystem::path& folder : confines_.writable) disks_.push_back(open_inside(folder));
  disks_.push_back(open_inside("/tmp"));
  group_.take(first);
  // While the other end is open here too, this cannot meet a closed pipe.
  if (::write(go.write_end.get(), "\n", 1) != 1) throw error_of_system("start the program");
}

Process::~Process() {
  if (child_ > 0) end();
}

pid_t Process::wait_until_ready(const Descriptor& ready, const Descriptor& info) {
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
    throw sandbox_error(streams_[1].beginning.empty() ? "it does not start" : streams_[1].beginning,
                        "allow this user to create namespaces, or use --unsafe for code that you trust");
  }
  std::string text(4096, '\0');
  const bool is_reported = ::read(info.get(), text.data(), text.size()) > 0;
  const auto first = is_reported ? static_cast<pid_t>(number_behind("\"child-pid\":", text)) : 0;
  first_handle_ = Descriptor(first <= 0 ? -1 : ::pidfd_open(first, 0));
  if (!first_handle_.is_open()) throw sandbox_error("bubblewrap does not report its process");
  return first;
}

Outcome Process::watch(const std::vector<std::filesystem::path>& results) {
  const Stopwatch stopwatch;
  const auto seconds = [&] { return stopwatch.milliseconds() / 1000; };
  Outcome outcome;
  double stopped_at = 0, busy_at = 0;
  while (!has_ended()) {
    drain();
    if (outcome.limit != Limit::none) {
      if (seconds() - stopped_at > end_seconds) throw sandbox_error("a killed program does not end");
      continue;
    }
    const Usage usage = usage_of_all(proc_, user_);
    outcome.peak_memory = std::max(outcome.peak_memory, usage.memory);
    if (usage.cpu_seconds > outcome.cpu_seconds) outcome.cpu_seconds = usage.cpu_seconds, busy_at = seconds();
    outcome.limit = seconds() - busy_at > idle_seconds ? Limit::wall : exceeded(seconds(), usage);
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
  outcome.output = streams_[0].beginning;
  outcome.errors = streams_[1].beginning;
  outcome.output_bytes = streams_[0].bytes;
  outcome.error_bytes = streams_[1].bytes;
  if (outcome.limit == Limit::none) outcome.limit = limit_behind(outcome);
  for (std::size_t i = 0; i < results.size(); ++i)
    if (!copy_results(disks_[i], results[i], confines_.limits.disk) && outcome.limit == Limit::none)
      outcome.limit = Limit::disk;
  return outcome;
}

Limit Process::exceeded(double seconds, const Usage& usage) const {
  const ProcessLimits& limits = confines_.limits;
  if (seconds > limits.wall_seconds) return Limit::wall;
  if (usage.cpu_seconds > limits.cpu_seconds) return Limit::cpu;
  if (usage.memory > limits.memory) return Limit::memory;
  if (is_disk_full()) return Limit::disk;
  if (streams_[0].bytes + streams_[1].bytes > limits.output) return Limit::output;
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
    return std::ranges::any_of(confines_.writable, [&](const auto& folder) {
      return size_of(folder, confines_.limits.files) > confines_.limits.disk;
    });
  return std::ranges::any_of(disks_, [&](const Descriptor& disk) {
    struct statfs status {};
    return ::fstatfs(disk.get(), &status) == 0 &&
           (status.f_bavail == 0 || status.f_files - status.f_ffree > confines_.limits.files);
  });
}

bool Process::has_ended() {
  std::array<pollfd, 3> waited{{{child_handle_.get(), POLLIN, 0},
                                {streams_[0].read_end.get(), POLLIN, 0},
                                {streams_[1].read_end.get(), POLLIN, 0}}};
  ::poll(waited.data(), waited.size(), watch_milliseconds);
  return waited[0].revents != 0;
}

void Process::drain() {
  const std::size_t keep = confines_.limits.kept_output;
  std::array<char, block_size> block;
  for (Stream& stream : streams_)
    for (int i = 0; i < 64; ++i) {  // not more, so that the watcher gets its turn
      const ssize_t got = ::read(stream.read_end.get(), block.data(), block.size());
      if (got == 0) stream.read_end.close();
      if (got <= 0) break;
      const auto size = static_cast<std::size_t>(got);
      stream.bytes += size;
      stream.beginning.append(block.data(), std::min(size, keep - std::min(keep, stream.beginning.size())));
    }
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

}  // namespace texel::sandbox
