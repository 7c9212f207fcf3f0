// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "core/error.hpp"

namespace texel {

/// The columns of the terminal at a file descriptor, 100 at most; nothing where there is none.
std::optional<std::size_t> terminal_columns(int file_descriptor);

/// Text in lines of at most so many columns, each after `indent` blanks. Lines are broken at blanks, so a
/// longer path stays whole. A line keeps the blanks that it begins with, and what does not fit goes on below
/// its first word: in a list with explanations below the word after two or more blanks.
std::string wrapped(const std::string& text, std::size_t columns, std::size_t indent = 0);

/// The same in lines that fit the terminal on standard output, or 80 columns where it is none.
std::string fitted(const std::string& text, std::size_t indent = 0);

/// Hands what was printed so far to the system. Throws Error (exit 3) when standard output does not take all
/// of it: the disk is full, the pipe has no reader.
void flush_output();

/// What a program's main does: the exit code of `run`, or that of the Error that it throws, which is printed.
/// 3 where standard output did not take all that was printed; a pipe without a reader does not end the
/// program before it has said so.
int run_main(const std::string& program, const std::function<Exit()>& run);

}  // namespace texel
