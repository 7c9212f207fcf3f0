// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

namespace texel::window {

/// Opens a file at a line in the user's editor: $VISUAL where it is set, else Visual Studio Code (`code -g`).
/// Line and column from 1; 0: the file alone. Does not wait for the editor. Throws Error (exit 3) when there
/// is none.
void open_in_editor(const std::filesystem::path& file, int line, int column = 0);

/// Puts a PNG into the clipboard by wl-copy or xclip: GLFW has only text. Throws Error (exit 3) when neither
/// is installed.
void copy_png(const std::filesystem::path& png);

}  // namespace texel::window
