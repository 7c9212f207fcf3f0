// SPDX-License-Identifier: MIT
#include "grade/sandbox.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <map>
#include <string_view>

#include "core/error.hpp"
#include "sandbox_filter.hpp"
#include "sandbox_process.hpp"

namespace texel::grade {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

void append(Words& line, const Words& words) {
  line.insert(line.end(), words.begin(), words.end());
}

void check(const Sandbox& sandbox, const Words& command) {
  if (command.empty() || command[0].empty()) throw Error::usage("a sandbox needs a command");
  const bool as_somebody_else = !sandbox.unsafe && ::geteuid() == 0;
  const auto check_folder = [](const fs::path& folder) {
    if (!folder.is_absolute() || folder != folder.lexically_normal() || !folder.has_filename())
      throw Error::usage(fmt::format("'{}' is not the absolute path of a folder", folder.string()),
                         "start it with /, and use no '.', no '..' and no / at its end");
    if (!fs::is_directory(folder)) throw sandbox_error("there is no folder " + folder.string());
  };
  for (const fs::path& folder : sandbox.read_only) {
    check_folder(folder);
    constexpr fs::perms readable = fs::perms::others_read | fs::perms::others_exec;
    if (as_somebody_else && (fs::status(folder).permissions() & readable) != readable)
      throw sandbox_error(
          fmt::format("other users cannot read {0}; type chmod -R o+rX {0}", folder.string()));
  }
  for (const fs::path& folder : sandbox.writable) check_folder(folder);
}

std::map<std::string, std::string> environment(const Sandbox& sandbox) {
  std::map<std::string, std::string> all = {{"PATH", "/usr/bin:/bin"}, {"HOME", "/tmp"}, {"LANG", "C.UTF-8"}};
  for (const auto& [name, value] : sandbox.environment) all[name] = value;
  return all;
}

/// The words in front of the program that set its own limits.
Words limits(const Sandbox& sandbox) {
  const SandboxLimits& limits = sandbox.limits;
  const auto cpu = static_cast<std::uint64_t>(std::ceil(limits.cpu_seconds));
  Words line = {"prlimit", fmt::format("--as={}", limits.address_space),
                // The soft limit sends a signal of its own, the hard one kills who ignores it.
                fmt::format("--cpu={}:{}", cpu, cpu + 1), fmt::format("--fsize={}", limits.disk),
                fmt::format("--nofile={}", limits.open_files), "--core=0"};
  // Outside it would count all that the caller runs.
  if (!sandbox.unsafe) line.push_back(fmt::format("--nproc={}", limits.processes));
  line.push_back("--");
  return line;
}

/// An id that no account and no other sandbox has, so that the limit on processes counts this sandbox alone.
unsigned unprivileged_id() {
  constexpr unsigned at_once = 64;
  static std::atomic<unsigned> counter = 0;
  const unsigned slot = counter++ % at_once;
  const auto process = static_cast<unsigned>(::getpid());
  std::uint64_t inside = 0;
  std::uint64_t outside = 0;
  std::uint64_t count = 0;
  std::ifstream("/proc/self/uid_map") >> inside >> outside >> count;
  constexpr unsigned high = 1'800'000'000;  // process ids are below 2^22, so that this ends below 2^31
  if (count > 1U << 31U) return high + process * at_once + slot;
  return 10'000 + process % 800 * at_once + slot;  // a container that has 65536 ids
}

/// The folders around a mount, which root's bwrap would close to others.
Words parents(const fs::path& folder) {
  Words line;
  fs::path parent = "/";
  for (const fs::path& part : folder.parent_path().relative_path())
    append(line, {"--dir", (parent /= part).string()});
  return line;
}

/// What bwrap does before the first process, as words for its --args.
Words walls(const Sandbox& sandbox) {
  constexpr std::uint64_t page = 4096;
  const Words disk = {"--size", fmt::format("{}", sandbox.limits.disk / page * page), "--perms", "0777",
                      "--tmpfs"};
  Words line = {"--unshare-ipc", "--unshare-pid", "--unshare-net", "--unshare-uts", "--unshare-cgroup-try"};
  append(line,
         {"--hostname", "sandbox", "--new-session", "--as-pid-1", "--die-with-parent", "--info-fd", "7"});
  append(line, {"--cap-drop", "ALL", "--clearenv"});
  // Root needs no user namespace, and its folders may be closed to others: it builds as root and keeps just
  // what it takes to become somebody else.
  if (::geteuid() == 0)
    append(line, {"--cap-add", "CAP_SETUID", "--cap-add", "CAP_SETGID", "--cap-add", "CAP_SETPCAP"});
  else
    append(line, {"--unshare-user"});
  for (const auto& [name, value] : environment(sandbox)) append(line, {"--setenv", name, value});
  append(line, {"--ro-bind", "/usr", "/usr", "--dir", "/etc"});
  for (const char* path :
       {"/bin", "/sbin", "/lib", "/lib32", "/lib64", "/etc/ld.so.cache", "/etc/alternatives"})
    append(line, {"--ro-bind-try", path, path});
  append(line, {"--proc", "/proc", "--dev", "/dev"});
  append(line, disk);
  line.emplace_back("/tmp");
  for (const fs::path& folder : sandbox.read_only) {
    append(line, parents(folder));
    append(line, {"--ro-bind", folder.string(), folder.string()});
  }
  for (const fs::path& folder : sandbox.writable) {
    append(line, parents(folder));
    append(line, disk);
    line.push_back(folder.string());
  }
  // These two are in memory as well, and have no size.
  append(line, {"--remount-ro", "/dev", "--remount-ro", "/", "--chdir", sandbox.working_folder.string()});
  return line;
}

/// The words that make root somebody else. Only for the program: the first process must remain root's, or
/// bwrap's death, that of a process without capabilities, would not reach it.
Words become_nobody() {
  const std::string id = fmt::format("{}", unprivileged_id());
  return {"setpriv", "--reuid", id, "--regid", id, "--clear-groups", "--inh-caps=-all", "--bounding-set=-all",
          "--"};
}

Launch launch_of(const Sandbox& sandbox, const Words& command) {
  Launch launch;
  Words inside = first_process();
  if (!sandbox.unsafe && ::geteuid() == 0) append(inside, become_nobody());
  append(inside, limits(sandbox));
  append(inside, command);
  if (sandbox.unsafe) {
    launch.command = {"env", "-C", sandbox.working_folder.string()};
    for (const auto& [name, value] : environment(sandbox))
      launch.environment.push_back(fmt::format("{}={}", name, value));
  } else {
    launch.filter = seccomp_filter();
    launch.command = {"bwrap", "--args", "5"};
    if (!launch.filter.empty()) append(launch.command, {"--seccomp", "6"});
    launch.command.emplace_back("--");
    for (const std::string& word : walls(sandbox)) launch.arguments.append(word).push_back('\0');
  }
  append(launch.command, inside);
  return launch;
}

}  // namespace

const char* name_of(Limit limit) {
  switch (limit) {
    case Limit::none:
      return "";
    case Limit::wall:
      return "wall time";
    case Limit::cpu:
      return "processor time";
    case Limit::memory:
      return "memory";
    case Limit::disk:
      return "disk";
    case Limit::output:
      return "output";
  }
  return "";
}

Outcome run(const Sandbox& sandbox, const Words& command) {
  check(sandbox, command);
  Process process(sandbox, launch_of(sandbox, command));
  Outcome outcome = process.watch();
  if (!process.copy_writable() && outcome.limit == Limit::none) outcome.limit = Limit::disk;
  return outcome;
}

const std::string& sandbox_fault() {
  static const std::string fault = []() -> std::string {
    try {
      const Outcome outcome = run({}, {"true"});
      return outcome.succeeded() ? "" : "a program that does nothing fails: " + outcome.errors;
    } catch (const Error& error) {
      return error.what();
    }
  }();
  return fault;
}

}  // namespace texel::grade
