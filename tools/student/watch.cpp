// SPDX-License-Identifier: MIT
// `texel watch`: checks a lab after every save.
#include <fmt/format.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <optional>
#include <utility>

#include "commands.hpp"
#include "core/files.hpp"
#include "core/stopwatch.hpp"
#include "core/terminal.hpp"
#include "student.hpp"

namespace texel::tools {
namespace {

namespace fs = std::filesystem;

constexpr int kWatchMilliseconds = 100;

volatile std::sig_atomic_t interrupted = 0;

/// Keys that come as they are typed, until the end of the scope; nothing where standard input is no terminal.
class Keys {
 public:
  Keys() : is_terminal_(::tcgetattr(STDIN_FILENO, &before_) == 0) {
    if (!is_terminal_) return;
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    ::tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  }
  ~Keys() {
    if (is_terminal_) ::tcsetattr(STDIN_FILENO, TCSANOW, &before_);
  }
  Keys& operator=(Keys&&) = delete;

  /// The next key, or 0 after the time.
  [[nodiscard]] char wait(int milliseconds) const {
    pollfd input{is_terminal_ ? STDIN_FILENO : -1, POLLIN, 0};
    char key = 0;
    if (::poll(&input, 1, milliseconds) > 0 && ::read(STDIN_FILENO, &key, 1) != 1) key = 'q';
    return key;
  }

 private:
  termios before_{};
  bool is_terminal_;
};

bool is_program_text(const fs::path& file) {
  return file.extension() == ".cpp" || file.extension() == ".hpp";
}

class Watch {
 public:
  Watch(int lab, std::string context) : lab_(chosen_labs({lab}).front()), context_(std::move(context)) {}

  void run() {
    const Keys keys;
    // What changes while we build or check is noticed afterwards.
    watcher_.changed(files());
    check(/*build_first=*/true);
    while (interrupted == 0) {
      const char key = keys.wait(kWatchMilliseconds);
      if (key == 'q') return;
      if (key == 'h') hint();
      if (key == '\n' || key == '\r' || key == 'r') check(/*build_first=*/true);
      const std::vector<fs::path> changed = watcher_.changed(files());
      if (!changed.empty()) check(std::any_of(changed.begin(), changed.end(), is_program_text));
    }
  }

 private:
  [[nodiscard]] std::vector<fs::path> files() const { return check::edited_files(tree_.source, lab_); }

  /// Builds the lab where that is needed; whether there is a program of what was saved.
  bool build() {
    fmt::print("building…\n");
    flush_output();
    const std::string messages = check::build_program(tree_, lab_, fmt::format("./run watch {}", lab_.number),
                                                      [](const std::string& other) {
                                                        fmt::print("waiting for another build: {}\n", other);
                                                        flush_output();
                                                      });
    if (messages.empty()) return true;
    fmt::print("Your code cannot be built. The messages from the first error on:\n{}", fitted(messages));
    return false;
  }

  static void clear_screen() {
    if (::isatty(STDOUT_FILENO) != 0) fmt::print("\033[2J\033[H");
  }

  void check(bool build_first) {
    clear_screen();
    try {
      if (!build_first || build()) {
        const Stopwatch stopwatch;
        const std::optional<judge::LabResult> before =
            std::exchange(last_, checked({lab_}, context_).front());
        clear_screen();
        fmt::print("{}", report(*last_));
        for (std::size_t i = 0; before && i < last_->steps.size(); ++i)
          if (last_->steps[i].passed() && !before->steps[i].passed())
            fmt::print("{}", after_step(last_->steps[i].id));
        fmt::print("checked in {:.1f} s. ", stopwatch.milliseconds() / 1000);
      }
    } catch (const Error& error) {  // a marker that was spoilt, say: mended by the next save
      fmt::print("{}\n", error.what());
    }
    fmt::print("Save a file to check again; h: show a hint, q: quit.\n");
    flush_output();
  }

  void hint() {
    const judge::StepResult* next = last_ ? judge::next_step(last_->steps) : nullptr;
    fmt::print("{}", !last_  ? "Nothing is checked yet. Correct the first message above.\n"
                     : !next ? "All steps are done.\n"
                             : next_hint(*next));
    flush_output();
  }

  course::Lab lab_;
  std::string context_;
  check::OwnTree tree_ = own_tree();
  Watcher watcher_;
  std::optional<judge::LabResult> last_;  ///< of the checks
};

}  // namespace

Exit watch(int lab, const std::string& context) {
  for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { interrupted = 1; });
  Watch(lab, context).run();
  return Exit::holds;
}

}  // namespace texel::tools
