// SPDX-License-Identifier: MIT
#pragma once
#include <sys/types.h>

#include <string>
#include <vector>

#include "core/error.hpp"
#include "memory_group.hpp"
#include "sandbox/descriptor.hpp"
#include "sandbox/sandbox.hpp"

namespace texel::sandbox {

/// What every fault of the sandbox says: it is the machine's, not the program's.
Error sandbox_error(const std::string& what, const std::string& remedy = "");

/// How a sandbox is started.
struct Launch {
  std::vector<std::string> command;      ///< ends in `first_process()` and the untrusted program
  std::vector<std::string> environment;  ///< "NAME=value"
  std::string arguments;                 ///< what can be read at descriptor 5
  std::string filter;                    ///< what can be read at descriptor 6; bwrap tells of itself at 7
  unsigned user = 0;                     ///< the id of the program where there are no namespaces, or 0
};

/// The shell that runs first inside, before the untrusted program's own words. It says that all walls stand
/// (descriptor 3), waits until we watch (4), and gives back how the program ended. Being process 1 of its
/// namespace, it takes all others with it when it ends.
std::vector<std::string> first_process();

/// One stream of the program: its beginning is kept, the rest only counted.
class Stream {
 public:
  explicit Stream(Descriptor descriptor);
  /// Takes what is there, at most so much that the watcher gets its turn.
  void drain(std::size_t keep);
  [[nodiscard]] int fd() const { return descriptor_.get(); }
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  [[nodiscard]] const std::string& kept() const { return kept_; }

 private:
  Descriptor descriptor_;
  std::string kept_;
  std::uint64_t bytes_ = 0;
};

/// What processes use up together.
struct Usage {
  std::uint64_t memory = 0;  ///< resident bytes that are no file's
  double cpu_seconds = 0;
  std::size_t processes = 0;  ///< that did not end yet
};

/// Of the processes that a /proc shows, with those of their children that have ended: of one user, or of all.
Usage usage_of_all(const Descriptor& proc, unsigned user = 0);

/// A sandbox from its start to its end; killed when it is destroyed before.
class Process {
 public:
  /// Builds the walls, opens what is to be watched, and lets the program begin. Throws `sandbox_error` when
  /// it does not come so far.
  Process(const Confines& confines, const Launch& launch);
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Waits until the program and all that it started is gone, of itself or because of a limit.
  Outcome watch();

  /// Copies what the program wrote into these folders, one for each writable one; whether there was room for
  /// all.
  [[nodiscard]] bool copy_writable(const std::vector<std::filesystem::path>& to) const;

 private:
  struct Ended {
    int exit_code;
    Usage usage;  ///< its memory is that of the largest process
  };

  void start_in_namespaces(const Launch& launch);
  void start_as_another_user(const Launch& launch);
  void take_streams(Descriptor output, Descriptor errors);
  void wait_until_ready(const Descriptor& ready, const Descriptor& info);
  void open_inside();
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
  pid_t first_ = -1;               ///< process 1 inside
  Descriptor child_handle_;        ///< shows the child's end
  Descriptor first_handle_;        ///< kills all that is inside
  Descriptor go_;                  ///< a line into it lets the program begin
  Descriptor proc_;                ///< /proc as inside
  std::vector<Descriptor> disks_;  ///< the writable folders as inside, then /tmp
  std::vector<Stream> streams_;    ///< standard output and standard error
};

}  // namespace texel::sandbox
