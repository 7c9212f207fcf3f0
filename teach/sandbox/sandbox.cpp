// SPDX-License-Identifier: MIT
#include "sandbox/sandbox.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <memory>

#include "core/error.hpp"
#include "core/files.hpp"
#include "process.hpp"

namespace texel::sandbox {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

void append(Words& line, const Words& words) {
  line.insert(line.end(), words.begin(), words.end());
}

void check(const Confines& confines, const Words& command) {
  if (command.empty() || command[0].empty()) throw Error::usage("a sandbox needs a command");
  const bool as_somebody_else = ::geteuid() == 0;
  const auto check_folder = [](const fs::path& folder) {
    if (!folder.is_absolute() || folder != folder.lexically_normal() || !folder.has_filename())
      throw Error::usage(fmt::format("'{}' is not the absolute path of a folder", folder.string()),
                         "start it with /, and use no '.', no '..' and no / at its end");
    if (!fs::is_directory(folder)) throw sandbox_error("there is no folder " + folder.string());
  };
  for (const fs::path& folder : confines.read_only) {
    check_folder(folder);
    constexpr fs::perms readable = fs::perms::others_read | fs::perms::others_exec;
    if (as_somebody_else && (fs::status(folder).permissions() & readable) != readable)
      throw sandbox_error(
          fmt::format("other users cannot read {0}; type chmod -R o+rX {0}", folder.string()));
  }
  for (const fs::path& folder : confines.writable) check_folder(folder);
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
Words bwrap_arguments(const Confines& confines) {
  constexpr std::uint64_t page = 4096;
  const Words disk = {"--size", fmt::format("{}", confines.limits.disk / page * page), "--perms", "0777",
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
  for (const auto& [name, value] : environment_of(confines)) append(line, {"--setenv", name, value});
  append(line, {"--ro-bind", "/usr", "/usr", "--dir", "/etc"});
  for (const char* path :
       {"/bin", "/sbin", "/lib", "/lib32", "/lib64", "/etc/ld.so.cache", "/etc/alternatives"})
    append(line, {"--ro-bind-try", path, path});
  append(line, {"--proc", "/proc", "--dev", "/dev"});
  append(line, disk);
  line.emplace_back("/tmp");
  for (const fs::path& folder : confines.read_only) {
    append(line, parents(folder));
    append(line, {"--ro-bind", folder.string(), folder.string()});
  }
  for (const fs::path& folder : confines.writable) {
    append(line, parents(folder));
    append(line, disk);
    line.push_back(folder.string());
  }
  // These two are in memory as well, and have no size.
  append(line, {"--remount-ro", "/dev", "--remount-ro", "/", "--chdir", confines.working_folder.string()});
  return line;
}

/// The words that make root somebody else, without any right.
Words become(unsigned user) {
  const std::string id = fmt::format("{}", user);
  return {"/usr/bin/setpriv",    "--reuid", id, "--regid", id, "--clear-groups", "--inh-caps=-all",
          "--bounding-set=-all", "--"};
}

/// The command, held to its limits.
Words held(const ProcessLimits& limits, const Words& command) {
  Words line = prlimit_words(limits);
  append(line, {fmt::format("--nproc={}", limits.processes), "--"});
  append(line, command);
  return line;
}

/// What bwrap starts: its own words, then the shell that runs first inside, then the program. The shell says
/// that all walls stand (descriptor 3), waits until we watch (4), and gives back how the program ended. Being
/// process 1 of its namespace, it takes all others with it when it ends.
Launch launch_of(const Confines& confines, const Words& command) {
  Launch launch;
  launch.filter = seccomp_filter();
  launch.command = {"bwrap", "--args", "5"};
  if (!launch.filter.empty()) append(launch.command, {"--seccomp", "6"});
  append(
      launch.command,
      {"--", "/bin/sh", "-c",
       "printf r >&3; exec 3>&-; read -r go <&4 || exit 1; exec 4<&- 5<&- 6<&- 7>&-; \"$@\"; exit $?", "sh"});
  // Only the program is somebody else. The first process must remain root's, or bwrap's death, that of a
  // process without capabilities, would not reach it.
  if (::geteuid() == 0) append(launch.command, become(unprivileged_id()));
  append(launch.command, held(confines.limits, command));
  for (const std::string& word : bwrap_arguments(confines)) launch.arguments.append(word).push_back('\0');
  return launch;
}

/// An empty folder in place of a real one, which is put aside; afterwards the real one is back.
class Instead {
 public:
  Instead(fs::path folder, unsigned owner) : folder_(std::move(folder)), aside_(folder_.string() + ".aside") {
    fs::rename(folder_, aside_);
    fs::create_directory(folder_);
    if (::chown(folder_.c_str(), owner, owner) != 0) throw sandbox_error("cannot give away a folder");
  }
  ~Instead() {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
    fs::rename(aside_, folder_, ignored);
  }
  Instead& operator=(Instead&&) = delete;
  [[nodiscard]] const fs::path& aside() const { return aside_; }

 private:
  fs::path folder_, aside_;
};

/// Why a program that does nothing does not run so, or "".
std::string fault_of(Run run) {
  try {
    const Outcome outcome = run({}, {"true"});
    return outcome.succeeded() ? "" : "a program that does nothing fails: " + outcome.errors;
  } catch (const Error& error) {
    return error.what();
  }
}

}  // namespace

Outcome run_locked_in(const Confines& confines, const Words& command) {
  check(confines, command);
  return Process(confines, launch_of(confines, command)).watch(confines.writable);
}

Outcome run_as_another_user(const Confines& given, const Words& command) {
  if (::geteuid() != 0) throw sandbox_error("only root can run a program as another user");
  check(given, command);
  const unsigned user = unprivileged_id();
  // What the compiler keeps meanwhile: /tmp is shared.
  const ScratchFolder scratch;
  fs::permissions(scratch.path(), fs::perms::owner_all | fs::perms::group_exec | fs::perms::others_exec);
  const fs::path temporary = scratch.path() / "tmp";
  fs::create_directory(temporary);
  Confines confines = given;
  for (const char* name : {"HOME", "TMPDIR"}) confines.environment.emplace_back(name, temporary.string());
  confines.writable.push_back(temporary);
  std::vector<std::unique_ptr<Instead>> folders;
  for (const fs::path& folder : confines.writable) folders.push_back(std::make_unique<Instead>(folder, user));

  Launch launch;
  launch.user = user;
  launch.filter = seccomp_filter();
  if (launch.filter.empty()) throw sandbox_error("there is no filter for this processor's system calls");
  launch.command = become(user);
  append(launch.command, held(confines.limits, command));
  for (const auto& [name, value] : environment_of(confines)) launch.environment.push_back(name + "=" + value);
  std::vector<fs::path> real;
  for (std::size_t i = 0; i < given.writable.size(); ++i) real.push_back(folders[i]->aside());
  return Process(confines, launch).watch(real);
}

const std::string& sandbox_fault() {
  static const std::string fault = fault_of(run_locked_in);
  return fault;
}

const std::string& another_user_fault() {
  static const std::string fault = fault_of(run_as_another_user);
  return fault;
}

}  // namespace texel::sandbox
