// SPDX-License-Identifier: MIT
#include "desktop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <thread>
#include <vector>

#include "core/error.hpp"
#include "core/process.hpp"

namespace texel::window {
namespace {

namespace fs = std::filesystem;

/// Where a program of this name lies in PATH, or "".
fs::path program_in_path(const std::string& name) {
  if (name.find('/') != std::string::npos) return fs::exists(name) ? fs::path(name) : fs::path();
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (std::error_code unknown; fs::is_regular_file(fs::path(folder) / name, unknown))
      return fs::path(folder) / name;
  return {};
}

/// Its end is waited for beside the window: an editor may stay open as long as it likes.
void run_beside(std::vector<std::string> command) {
  std::thread([command = std::move(command)] {
    try {
      run_program(command, true);
    } catch (const Error&) {  // it was there a moment ago
    }
  }).detach();
}

}  // namespace

void open_in_editor(const fs::path& file, int line, int column) {
  const char* visual = std::getenv("VISUAL");
  std::vector<std::string> command;
  std::istringstream words(visual == nullptr ? "" : visual);
  for (std::string word; words >> word;) command.push_back(word);
  if (command.empty()) command = {"code"};
  if (program_in_path(command.front()).empty())
    throw Error::failed(
        fmt::format("there is no editor '{}' to open {}:{}", command.front(), file.string(), line), {},
        "set VISUAL to a command that opens a window, as VISUAL='gvim' or VISUAL='code'");
  const std::string editor = fs::path(command.front()).filename();
  const std::string place = column > 0 ? fmt::format("{}:{}:{}", file.string(), line, column)
                                       : fmt::format("{}:{}", file.string(), std::max(line, 1));
  if (editor == "code" || editor == "codium" || editor == "code-oss")
    command.insert(command.end(), {"-g", place});
  else if (editor == "subl" || editor == "zed")
    command.push_back(place);
  else  // vi, emacs, kate's and nano's way
    command.insert(command.end(), {fmt::format("+{}", std::max(line, 1)), file.string()});
  run_beside(std::move(command));
}

void copy_png(const fs::path& png) {
  // Through a shell for its "<": both programs read a picture from standard input.
  const bool is_wayland = std::getenv("WAYLAND_DISPLAY") != nullptr;
  const std::string tool = is_wayland ? "wl-copy" : "xclip";
  if (program_in_path(tool).empty())
    throw Error::failed(
        fmt::format("a picture gets into the clipboard by the program {}, which is missing", tool), {},
        is_wayland ? "install wl-clipboard" : "install xclip");
  const std::string command = is_wayland ? "exec wl-copy --type image/png < \"$1\""
                                         : "exec xclip -selection clipboard -t image/png -i \"$1\"";
  run_beside({"sh", "-c", command, "sh", png.string()});
}

}  // namespace texel::window
