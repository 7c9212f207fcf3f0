// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

/// Programs that nobody trusts, run where they can do no harm.
///
/// The walls are bubblewrap's: new user (or, for root, an id that nobody else has), process, network, mount,
/// IPC, host-name and control-group namespaces; of the file system only /usr and what the dynamic linker
/// needs, all read-only; a /proc and /tmp of its own; no capability; a seccomp filter; no terminal; nothing
/// on standard input; none of the caller's open files and environment. Everything in it dies with the
/// program, and with the caller.
///
/// What is installed below /usr can be read, so that solutions and references must lie elsewhere. As root,
/// the program runs under another id: what it shall read must be open to others.
namespace texel::grade {

/// What a program may use up. Sizes are in bytes. Measured on two processors: a lab's 1024x1024 snapshot on
/// llvmpipe needs 600 MB of address space (500 fail), of which 155 MB are resident; compiling lab 5's lab.cpp
/// less than 1000 MB and 325 MB. More processors need more, for threads. Mesa 25's software Vulkan keeps its
/// memory in a file of 128 MiB.
struct SandboxLimits {
  double wall_seconds = 60;
  double cpu_seconds = 60;                    ///< of all processes together
  std::uint64_t memory = 1U << 30U;           ///< resident and not from a file, of all processes together
  std::uint64_t address_space = 4ULL << 30U;  ///< of each process
  std::uint64_t disk = 256U << 20U;           ///< of each writable folder and of /tmp, and of one file
  std::uint64_t files = 4096;                 ///< how many, in each writable folder and in /tmp
  std::uint64_t processes = 64;               ///< and threads, at a time
  std::uint64_t open_files = 256;             ///< of each process
  std::uint64_t output = 16U << 20U;          ///< printed on both streams together
  std::size_t kept_output = 256U << 10U;      ///< how much of each stream is kept; what follows is dropped
};

/// A place to run in. Folders are absolute and keep their path inside.
struct Sandbox {
  std::vector<std::filesystem::path> read_only;

  /// Each is empty and in memory (the machine's, beside `limits.memory`) for the program, at most
  /// `limits.disk` large. When all is over, its regular files and folders are copied into the real folder,
  /// over what has the same name there; links and devices are left behind.
  std::vector<std::filesystem::path> writable;

  /// All of the environment but PATH, HOME (/tmp), and LANG, which may be given too.
  std::vector<std::pair<std::string, std::string>> environment;

  std::filesystem::path working_folder = "/tmp";
  SandboxLimits limits;

  /// Without bubblewrap: a plain process of the caller's, with the limits on time, address space, file size
  /// and output, whose process group is killed at the end. It can read and write what the caller can. Only
  /// for programs that one trusts.
  bool unsafe = false;
};

/// Which limit ended a program.
enum class Limit { none, wall, cpu, memory, disk, output };

/// "wall time", "processor time", "memory", "disk", "output", or "".
const char* name_of(Limit limit);

/// What became of a program. Nothing of it is proof of anything: the program chose its exit code.
struct Outcome {
  int exit_code = 0;  ///< as a shell says it: 128 + the signal that ended it, 127 for a missing program
  int signal = 0;     ///< that signal, or 0
  Limit limit = Limit::none;                        ///< the limit that ended it
  std::string output;                               ///< the beginning of standard output: any bytes
  std::string errors;                               ///< the beginning of standard error: any bytes
  std::uint64_t output_bytes = 0, error_bytes = 0;  ///< that were printed, kept or not
  double wall_seconds = 0;
  double cpu_seconds = 0;         ///< of all processes together
  std::uint64_t peak_memory = 0;  ///< resident bytes: of the largest process, or seen of all together

  [[nodiscard]] bool succeeded() const { return exit_code == 0 && limit == Limit::none; }
};

/// Runs `command` (a program and its arguments, no shell) and waits for its end. May be called by many
/// threads at once.
///
/// Throws Error (exit 3) when the sandbox is at fault and not the program: bubblewrap is missing or cannot
/// work here, a folder is missing, the results cannot be copied. Throws Error (exit 2) for an empty command
/// and a path that is not absolute.
Outcome run(const Sandbox& sandbox, const std::vector<std::string>& command);

/// Why programs cannot be locked in on this machine, or "" when they can. Tried once.
const std::string& sandbox_fault();

}  // namespace texel::grade
