// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>

namespace texel::gl {

/// Compilers find a missing `;` at the next token. Where that begins a line, this names the line before it,
/// after which the `;` is missing, with its text. `log` is the compiler's, and `text` what it read, as
/// ShaderSource::text has it. All other lines of the log stay as they are.
std::string at_missing_semicolons(std::string_view log, std::string_view text);

}  // namespace texel::gl
