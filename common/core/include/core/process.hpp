// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

namespace texel {

/// The exit code and output of a program.
struct Ran {
  int exit_code = 0;   ///< as a shell says it: 128 and the signal that ended it
  std::string output;  ///< standard output, and standard error too when both were asked for
};

/// Runs a program (a path, or a name in PATH) with its arguments, without a shell, and waits for its
/// end. Its standard input is empty. Throws Error (exit 3) when it cannot be started.
Ran run_program(const std::vector<std::string>& command, bool with_errors = false);

/// The same with its streams into open files, and its exit code.
int run_into(const std::vector<std::string>& command, int output, int errors);

}  // namespace texel
