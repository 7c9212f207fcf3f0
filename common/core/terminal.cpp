// SPDX-License-Identifier: MIT
#include "core/terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

namespace texel {

std::optional<std::size_t> terminal_columns(int file_descriptor) {
  winsize size{};
  if (::ioctl(file_descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col <= 20) return {};
  return std::min<std::size_t>(size.ws_col, 100);
}

std::string wrapped(const std::string& text, std::size_t columns, std::size_t indent) {
  std::string result, line;
  const auto flush = [&] {
    if (!line.empty()) result += std::string(indent, ' ') + line + "\n";
    line.clear();
  };
  bool is_first = true;  // word of a line of the text: it keeps the blanks before it
  std::size_t hang = 0;  // of what goes on below
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t letters = is_first ? text.find_first_not_of(' ', at) : at;
    const std::size_t end = std::min(text.find_first_of(" \n", letters), text.size());
    std::string word = text.substr(at, end - at);
    if (const std::size_t gap = is_first ? text.find("  ", letters) : 0; is_first)
      hang = std::min(columns / 2,
                      (gap < text.find('\n', letters) ? text.find_first_not_of(' ', gap) : letters) - at);
    if (!line.empty() && indent + line.size() + 1 + word.size() > columns) flush(), word.insert(0, hang, ' ');
    line += (line.empty() ? "" : " ") + word;
    is_first = end < text.size() && text[end] == '\n';
    if (is_first) line.empty() ? void(result += '\n') : flush();
    at = end + 1;
  }
  flush();
  return result;
}

std::string fitted(const std::string& text, std::size_t indent) {
  return wrapped(text, terminal_columns(STDOUT_FILENO).value_or(80), indent);
}

void flush_output() {
  errno = 0;
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
    throw Error::failed(
        fmt::format("cannot write to standard output: {}",
                    errno != 0 ? std::strerror(errno) : "the disk is full, or nobody reads it"));
}

int run_main(const std::string& program, const std::function<Exit()>& run) {
  // Not ignored: programs that this one starts would ignore the signal too.
  std::signal(SIGPIPE, [](int) {});
  try {
    const Exit exit = run();
    flush_output();
    return static_cast<int>(exit);
  } catch (const std::exception& error) {
    std::string text = program + ": " + error.what() + "\n";
    if (const auto columns = terminal_columns(STDERR_FILENO)) text = wrapped(text, *columns);
    std::fputs(text.c_str(), stderr);
    const auto* ours = dynamic_cast<const Error*>(&error);  // else out of memory, a fault of ours
    return static_cast<int>(ours != nullptr ? ours->exit_code() : Exit::failed);
  }
}

}  // namespace texel
