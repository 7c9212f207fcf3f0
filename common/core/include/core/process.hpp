// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

/// Programs that are run, also with limits, and what became of them.
namespace texel {

/// The exit code and output of a program.
struct Ran {
  int exit_code = 0;   ///< as a shell says it: 128 and the signal that ended it
  std::string output;  ///< standard output, and standard error too when both were asked for
};

/// Runs a program (a path, or a name in PATH) with its arguments, without a shell, and waits for its
/// end. Its standard input is empty. Throws Error (exit 3) when it cannot be started.
Ran run_program(const std::vector<std::string>& command, bool with_errors = false);

/// Runs a program as above with its streams into open files, and gives its exit code.
int run_into(const std::vector<std::string>& command, int output, int errors);

/// The seconds that several programs may still take together.
using TimeBudget = std::atomic<double>;

/// What a program may use up. Sizes are in bytes. Measured on two processors: a lab's 1024x1024 snapshot on
/// llvmpipe needs 600 MB of address space, of which 155 MB are resident; compiling lab 5's lab.cpp less than
/// 1000 MB and 325 MB. Mesa 25's software Vulkan keeps its memory in a file of 128 MiB.
struct ProcessLimits {
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

/// Where a program runs, and what it may do; run_plainly holds it to part of this. Folders are absolute and
/// keep their path inside a sandbox.
struct Confines {
  std::vector<std::filesystem::path> read_only;

  /// Each is empty and in memory (the machine's, beside `limits.memory`) for the program, at most
  /// `limits.disk` large. When all is over, its regular files and folders are copied into the real folder,
  /// over what has the same name there; links and devices are left behind.
  std::vector<std::filesystem::path> writable;

  /// All of the environment but PATH, HOME (/tmp), and LANG, which may be given too.
  std::vector<std::pair<std::string, std::string>> environment;

  std::filesystem::path working_folder = "/tmp";
  ProcessLimits limits;
};

/// The whole environment of the program.
std::map<std::string, std::string> environment_of(const Confines& confines);

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

/// "prlimit …": the words before a program that limit its own address space, time, files and output.
std::vector<std::string> prlimit_words(const ProcessLimits& limits);

/// Runs `command` (a program and its arguments, no shell) as a plain process and waits for its end: with the
/// environment and working folder of the confines, and with their limits on time, address space and file
/// size. It can read and write what the caller can: only for programs that one trusts. Throws Error (exit 3)
/// when it cannot be started.
Outcome run_plainly(const Confines& confines, const std::vector<std::string>& command);

/// How programs are run: plainly, or in a sandbox.
using Run = Outcome (*)(const Confines&, const std::vector<std::string>&);

}  // namespace texel
