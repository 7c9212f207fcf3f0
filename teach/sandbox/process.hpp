// SPDX-License-Identifier: MIT
#pragma once
#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "sandbox/descriptor.hpp"
#include "sandbox/sandbox.hpp"

namespace texel::sandbox {

/// What every fault of the sandbox says: it is the machine's, not the program's.
Error sandbox_error(const std::string& what, const std::string& remedy = "");

/// How a sandbox is started.
struct Launch {
  std::vector<std::string> command;      ///< ends in the untrusted program
  std::vector<std::string> environment;  ///< "NAME=value"
  std::string arguments;                 ///< of bwrap: what can be read at descriptor 5
  std::string filter;  ///< at descriptor 6, or for the program itself; bwrap tells of itself at 7
  unsigned user = 0;   ///< the id of the program where there are no namespaces, or 0
};

/// One stream of the program: the rest is only counted.
struct Stream {
  Descriptor read_end;
  std::string beginning = {};
  std::uint64_t bytes = 0;
};

/// What processes use up together.
struct Usage {
  std::uint64_t memory = 0;  ///< resident bytes that are no file's
  double cpu_seconds = 0;
  std::size_t processes = 0;  ///< that did not end yet
};

/// The seccomp filter of the sandbox, as bwrap's --seccomp takes it: an array of `struct sock_filter`. It
/// refuses the system calls that no lab needs and that break out of sandboxes or hold memory which no limit
/// counts. Empty for a processor whose calls we do not know.
std::string seccomp_filter();

/// Copies the regular files and folders of a folder that an untrusted program filled into a real one, over
/// what has the same name there. No link is followed; what is neither file nor folder, folders in more than
/// 16 others, and what cannot have its name there are left behind: the program chose them. Stops after
/// `limit` bytes, counting holes, and returns whether all was copied. Throws Error (exit 3) when the real
/// folder cannot be written.
bool copy_results(const Descriptor& from, const std::filesystem::path& to, std::uint64_t limit);

/// A control group (cgroup v2) around one sandbox: the kernel counts all memory of its processes, also what
/// none of them shows, such as files in memory, pipes and page tables. Where the grader may not make groups
/// this does nothing.
class MemoryGroup {
 public:
  /// `most`: bytes. One more ends all processes of the group.
  explicit MemoryGroup(std::uint64_t most);
  ~MemoryGroup();
  MemoryGroup& operator=(MemoryGroup&&) = delete;

  /// Moves a process into the group. What it starts from now on is in it too.
  void take(pid_t process) const;
  /// Whether the kernel ended the processes for their memory.
  [[nodiscard]] bool was_exceeded() const;

 private:
  std::filesystem::path folder_;  ///< empty: there is none
};

/// A sandbox from its start to its end; killed when it is destroyed before.
class Process {
 public:
  /// Builds the walls, opens what is to be watched, and lets the program begin. Throws `sandbox_error` when
  /// it does not come so far.
  Process(const Confines& confines, const Launch& launch);
  ~Process();
  Process& operator=(Process&&) = delete;

  /// Waits until the program and all that it started is gone, of itself or because of a limit. Then copies
  /// what the program wrote into the folders of `results`, one for each writable one.
  Outcome watch(const std::vector<std::filesystem::path>& results);

 private:
  struct Ended {
    int exit_code;
    Usage usage;  ///< its memory is that of the largest process
  };

  void start(const Launch& launch, const std::vector<int>& descriptors);
  void start_as_another_user(const Launch& launch, const std::vector<int>& streams);
  void start_in_namespaces(const Launch& launch, std::vector<int> descriptors);
  /// Process 1 inside, once it says that all walls stand.
  pid_t wait_until_ready(const Descriptor& ready, const Descriptor& info);
  [[nodiscard]] bool has_ended();
  [[nodiscard]] Limit exceeded(double seconds, const Usage& usage) const;
  [[nodiscard]] Limit limit_behind(const Outcome& outcome) const;
  [[nodiscard]] bool is_disk_full() const;
  void drain();
  void stop();
  Ended end();

  const Confines& confines_;
  MemoryGroup group_;
  unsigned user_ = 0;              ///< of the program where there are no namespaces, or 0
  pid_t child_ = -1;               ///< bwrap, outside; without namespaces the program
  Descriptor child_handle_;        ///< shows the child's end
  Descriptor first_handle_;        ///< of process 1 inside: kills all that is inside
  Descriptor proc_;                ///< /proc as inside
  std::vector<Descriptor> disks_;  ///< the writable folders as inside, then /tmp
  std::vector<Stream> streams_;    ///< standard output and standard error
};

}  // namespace texel::sandbox
