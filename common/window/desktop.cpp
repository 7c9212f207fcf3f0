// SPDX-License-Identifier: MIT
#include "desktop.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "core/error.hpp"
#include "core/process.hpp"

namespace texel::window {
namespace {

namespace fs = std::filesystem;

bool is_installed(const std::string& program) {
  return run_program({"sh", "-c", "command -v \"$1\"", "sh", program}, true).exit_code == 0;
}

/// Starts a shell's command with arguments "$1" and so on. Nobody waits for its end: an editor may stay open
/// as long as it likes.
void run_beside(const std::string& command, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), {"sh", "-c", command + " >/dev/null 2>&1 &", "sh"});
  run_program(arguments);
}

}  // namespace

void open_in_editor(const fs::path& file, int line, int column) {
  const char* visual = std::getenv("VISUAL");
  const std::string command = visual == nullptr || *visual == '\0' ? "code" : visual;
  const std::string program = command.substr(0, command.find(' '));
  if (!is_installed(program))
    throw Error::failed(fmt::format("there is no editor '{}' to open {}:{}", program, file.string(), line),
                        {}, "set VISUAL to a command that opens a window, as VISUAL='gvim' or VISUAL='code'");
  const std::string editor = fs::path(program).filename();
  line = std::max(line, 1);
  const std::string place = column > 0 ? fmt::format("{}:{}:{}", file.string(), line, column)
                                       : fmt::format("{}:{}", file.string(), line);
  if (editor == "code" || editor == "codium" || editor == "code-oss")
    run_beside(command + " -g \"$1\"", {place});
  else if (editor == "subl" || editor == "zed")
    run_beside(command + " \"$1\"", {place});
  else  // vi, emacs, kate's and nano's way
    run_beside(command + " \"$@\"", {fmt::format("+{}", line), file.string()});
}

void copy_png(const fs::path& png) {
  const bool is_wayland = std::getenv("WAYLAND_DISPLAY") != nullptr;
  const std::string tool = is_wayland ? "wl-copy" : "xclip";
  if (!is_installed(tool))
    throw Error::failed(
        fmt::format("a picture gets into the clipboard by the program {}, which is missing", tool), {},
        is_wayland ? "install wl-clipboard" : "install xclip");
  run_beside(
      is_wayland ? "wl-copy --type image/png < \"$1\"" : "xclip -selection clipboard -t image/png -i \"$1\"",
      {png.string()});
}

}  // namespace texel::window
