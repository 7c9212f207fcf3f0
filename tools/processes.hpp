// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace texel::tools {

/// A program with its arguments; the first is its path.
using Command = std::vector<std::string>;

/// Runs every command, `at_once` of them at a time, and calls `ended(index, status)` as each ends, in that
/// order; a status above 128 is a signal's number and 128. Their output goes where ours goes. Throws Error
/// (exit 3) when a program cannot be started, after those that run have ended.
void run_all(const std::vector<Command>& commands, int at_once,
             const std::function<void(std::size_t, int)>& ended);

}  // namespace texel::tools
