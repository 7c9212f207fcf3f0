// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace texel {

/// Any bytes as text that can be shown: what is no UTF-8, controls, and the marks that turn the direction of
/// writing become U+FFFD. HTML, CSV and the like must still escape it.
std::string plain_text(std::string_view bytes);

/// The same line by line: line feeds stay, tabs become spaces.
std::string plain_lines(std::string_view bytes);

/// A text's lines, without the LF or CR LF that ends each. Behind the last one begins no line.
std::vector<std::string> lines_of(std::string_view text);

/// Without white space at its beginning and end.
std::string_view trimmed(std::string_view text);

/// Whether this is of a name in C++ or GLSL: an ASCII letter, a digit, '_'.
bool is_word(char c);

/// ASCII capitals made small.
std::string lower_case(std::string_view text);

}  // namespace texel
