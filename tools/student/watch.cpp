// SPDX-License-Identifier: MIT
// `texel watch`: checks a lab after every save.
#include <fmt/format.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <optional>
#include <set>

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
    check(/*build=*/true);
    while (interrupted == 0) {
      switch (keys.wait(kWatchMilliseconds)) {
        case 'q':
          return;
        case 'h':
          hint();
          break;
        case '\n':
        case '\r':
        case 'r':
          check(true);
          break;
        default:
          break;
      }
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
    fmt::print("Your code cannot be built. The messages from the first error on:\n{}", wrapped(messages, 0));
    return false;
  }

  void check(bool build_first) {
    const bool is_terminal = ::isatty(STDOUT_FILENO) != 0;
    if (is_terminal) fmt::print("\033[2J\033[H");  // a clean screen
    try {
      if (!build_first || build()) {
        const Stopwatch stopwatch;
        const std::vector<judge::LabResult> labs = checked({lab_}, context_);
        const judge::StepResult* next = next_step(labs.front());
        next_ = next != nullptr ? next->id : "";
        if (is_terminal) fmt::print("\033[2J\033[H");
        fmt::print("{}", report(labs.front(), wants_colors()));
        std::set<std::string> right;
        for (const judge::StepResult& step : labs.front().steps)
          if (step.status == judge::Status::passed) right.insert(step.id);
        for (const std::string& step : right)
          if (right_ && !right_->contains(step)) fmt::print("{}", after_step(step));
        right_ = std::move(right);
        fmt::print("checked in {:.1f} s. ", stopwatch.milliseconds() / 1000);
      }
    } catch (const Error& error) {  // a marker that was spoilt, say: mended by the next save
      fmt::print("{}\n", error.what());
    }
    fmt::print("Save a file to check again; h: show a hint, q: quit.\n");
    flush_output();
  }

  void hint() {
    for (const course::Step& step : lab_.steps)
      if (step.id == next_) fmt::print("{}", next_hint(step));
    if (!next_) fmt::print("Nothing is checked yet. Correct the first message above.\n");
    if (next_ == "") fmt::print("All steps are done.\n");
    flush_output();
  }

  course::Lab lab_;
  std::string context_;
  check::OwnTree tree_ = own_tree();
  Watcher watcher_;
  std::optional<std::set<std::string>> right_;  ///< steps of the last check
  std::optional<std::string> next_;  ///< the step that comes next, "" after the last; unknown before a check
};

}  // namespace

Exit watch(int lab, const std::string& context) {
  struct sigaction action {};
  action.sa_handler = [](int) { interrupted = 1; };
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
  Watch(lab, context).run();
  return Exit::holds;
}

}  // namespace texel::tools
