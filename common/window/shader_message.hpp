// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

namespace texel::window {

/// A compiler's messages as one says them to a student: the first with its source line, the rest on request.
struct ErrorMessage {
  std::string first;           ///< "shaders/05_normal_map/normal_map.frag:20:25: error: …"
  std::string source_line;     ///< the line that it names, or ""
  std::string rest;            ///< the other lines, or ""
  int others = 0;              ///< how many lines the rest has
  std::filesystem::path file;  ///< on this machine; "" where it names none
  int line = 0, column = 0;    ///< counted from 1; 0: unknown
};

/// Of an error's text. A file is looked for below `root`, the tree's.
ErrorMessage read_message(const std::string& text, const std::filesystem::path& root);

}  // namespace texel::window
