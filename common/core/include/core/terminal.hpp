// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <exception>
#include <optional>
#include <string>

namespace texel {

/// The columns of the terminal at a file descriptor, 100 at most; nothing where there is none.
std::optional<std::size_t> terminal_columns(int file_descriptor);

/// Text in lines of at most so many columns, each after `indent` blanks. Lines are broken at blanks, so a
/// longer path stays whole. A line keeps the blanks that it begins with.
std::string wrapped(const std::string& text, std::size_t columns, std::size_t indent = 0);

/// Says on standard error why a program ends; in a terminal in lines that fit.
void print_error(const std::string& program, const std::exception& error);

}  // namespace texel
