// SPDX-License-Identifier: MIT
#include "core/crash.hpp"

#include <execinfo.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>

#include "core/plain_text.hpp"
#include "core/process.hpp"

namespace texel {

static void report(int signal) {
  std::array<void*, 40> calls{};  // each as "…/bin/lab03_obj_texcoords(+0x1234)[0x55d0c0de1234]"
  const int count = ::backtrace(calls.data(), static_cast<int>(calls.size()));
  ::backtrace_symbols_fd(calls.data(), count, STDERR_FILENO);
  ::raise(signal);  // which ends the program now
}

void report_crashes() {
  void* any = nullptr;
  ::backtrace(&any, 1);  // asks for memory the first time, which a program that dies may not get
  // A stack of its own: a function that calls itself without end has used up the other one.
  static std::array<char, 65536> stack;
  const stack_t own{.ss_sp = stack.data(), .ss_flags = 0, .ss_size = stack.size()};
  ::sigaltstack(&own, nullptr);
  struct sigaction action {};
  action.sa_handler = report;
  action.sa_flags = SA_ONSTACK | static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGABRT, SIGXCPU}) ::sigaction(signal, &action, nullptr);
}

std::string crash_place(const std::string& errors, const std::filesystem::path& program,
                        const std::filesystem::path& folder) {
  std::vector<std::string> command = {"sh", "-c", "exec addr2line -i -e \"$@\" 2>/dev/null", "sh", program};
  const std::string begin = program.string() + "(+";
  int call = 0;  // 0: report, 1: the C library, 2: what died; then calls, each as the place behind it
  for (const std::string& line : lines_of(errors)) {
    if (call == 0 && !line.starts_with(begin)) continue;
    const int further = call++ == 2 ? 0 : 1;
    if (line.starts_with(begin))
      command.push_back(fmt::format("{:#x}", std::strtoull(&line[begin.size()], nullptr, 16) - further));
  }
  const std::string name = "/" + folder.filename().string() + "/";
  for (const std::string& line : lines_of(run_program(command).output))  // "/…/labs/03_obj/a.cpp:41 (…)"
    if (const auto at = line.rfind(name);
        at != line.npos && !line.ends_with('?') &&
        std::filesystem::exists(folder.parent_path() / line.substr(at + 1, line.rfind(':') - at - 1)))
      return line.substr(at + 1, line.find(' ', at) - at - 1);
  return {};
}

}  // namespace texel
