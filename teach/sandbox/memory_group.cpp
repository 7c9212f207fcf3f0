// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <thread>

#include "process.hpp"

namespace texel::sandbox {
namespace {

namespace fs = std::filesystem;

/// Where the kernel shows its groups (cgroups(7)).
const fs::path kGroups = "/sys/fs/cgroup";

/// Writes one of the kernel's files with one call, as it wants it. Returns 0 or the error's number.
int put(const fs::path& file, const std::string& text) {
  const Descriptor opened(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
  if (!opened.is_open()) return errno;
  return ::write(opened.get(), text.data(), text.size()) < 0 ? errno : 0;
}

bool has_word(const fs::path& file, const std::string& wanted) {
  std::ifstream stream(file);
  for (std::string word; stream >> word;)
    if (word == wanted) return true;
  return false;
}

/// The group of this process; empty where the machine has only the first version of groups.
fs::path own_group() {
  std::ifstream lines("/proc/self/cgroup");
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("0::/") && fs::exists(kGroups / "cgroup.controllers"))
      return (kGroups / line.substr(4)).lexically_normal();
  return {};
}

/// The group in which the grader makes others, or why it cannot.
struct Parent {
  fs::path folder;
  std::string fault;
};

/// A group that has processes cannot divide its memory. So the grader moves into one below its own.
Parent divided_group() {
  const fs::path own = own_group(), aside = own / "grader";
  if (own.empty() || !has_word(own / "cgroup.controllers", "memory"))
    return {{}, "the system has no cgroup v2 with the controller 'memory' for it"};
  std::error_code error;
  fs::create_directory(aside, error);
  if (error) return {{}, fmt::format("it may not make a cgroup in {}: {}", own.string(), error.message())};
  const std::string process = fmt::format("{}", ::getpid());
  int fault = put(aside / "cgroup.procs", process);
  if (fault == 0) fault = put(own / "cgroup.subtree_control", "+memory");
  if (fault == 0) return {own, ""};
  put(own / "cgroup.procs", process);
  fs::remove(aside, error);
  return {{}, fmt::format("it cannot divide the cgroup {}: {}", own.string(), std::strerror(fault))};
}

const Parent& parent() {
  static const Parent parent = divided_group();
  return parent;
}

}  // namespace

const std::string& memory_group_fault() {
  return parent().fault;
}

MemoryGroup::MemoryGroup(std::uint64_t most) {
  if (parent().folder.empty()) return;
  static std::atomic<unsigned> counter = 0;
  folder_ = parent().folder / fmt::format("sandbox-{}-{}", ::getpid(), counter++);
  std::error_code error;
  fs::create_directory(folder_, error);
  if (error) throw sandbox_error(fmt::format("cannot make {}: {}", folder_.string(), error.message()));
  // A machine without swap has no file for it.
  put(folder_ / "memory.swap.max", "0");
  if (put(folder_ / "memory.max", fmt::format("{}", most)) != 0 ||
      put(folder_ / "memory.oom.group", "1") != 0)
    throw sandbox_error(fmt::format("cannot limit the memory of {}", folder_.string()));
}

MemoryGroup::~MemoryGroup() {
  std::error_code error;
  // The kernel takes a moment to forget processes that ended.
  for (int i = 0; i < 100 && !folder_.empty() && !fs::remove(folder_, error) && error; ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

void MemoryGroup::take(pid_t process) const {
  if (folder_.empty()) return;
  if (const int fault = put(folder_ / "cgroup.procs", fmt::format("{}", process)); fault != 0)
    throw sandbox_error(
        fmt::format("cannot move a process into {}: {}", folder_.string(), std::strerror(fault)));
}

bool MemoryGroup::was_exceeded() const {
  std::ifstream stream(folder_ / "memory.events");
  std::string event;
  for (std::uint64_t count = 0; stream >> event >> count;)
    if (event == "oom_kill" && count > 0) return true;
  return false;
}

}  // namespace texel::sandbox
