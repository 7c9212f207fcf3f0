// SPDX-License-Identifier: MIT
#include "another_user.hpp"

#include <fcntl.h>
#include <linux/close_range.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <thread>

#include "process.hpp"

namespace texel::sandbox {
namespace {

/// The words as exec takes them.
std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> all;
  for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
  all.push_back(nullptr);
  return all;
}

}  // namespace

pid_t spawn_filtered(const std::vector<std::string>& command, const std::vector<std::string>& environment,
                     const std::string& filter, const std::vector<int>& descriptors,
                     const std::filesystem::path& folder) {
  const std::vector<char*> words = pointers(command), variables = pointers(environment);
  std::string instructions = filter;
  sock_fprog program{static_cast<unsigned short>(filter.size() / sizeof(sock_filter)),
                     reinterpret_cast<sock_filter*>(instructions.data())};
  const std::string program_file = "/usr/bin/" + command[0];
  const int count = static_cast<int>(descriptors.size());
  std::vector<int> copies(descriptors.size());
  int said[2];  // stays empty if the program starts
  if (::pipe2(said, O_CLOEXEC) != 0) return -1;
  const Descriptor listen(said[0]);
  Descriptor tell(said[1]);
  const pid_t child = ::fork();
  if (child != 0) {
    tell.close();
    char byte = 0;
    if (child < 0 || ::read(listen.get(), &byte, 1) == 0) return child;
    ::waitpid(child, nullptr, 0);
    return -1;
  }
  // Other threads held locks when the process was copied: from here on only system calls.
  ::setsid();
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (int signal = 1; signal < NSIG; ++signal) ::signal(signal, SIG_DFL);
  for (std::size_t i = 0; i < descriptors.size(); ++i)
    copies[i] = ::fcntl(descriptors[i], F_DUPFD_CLOEXEC, count);
  for (std::size_t i = 0; i < descriptors.size(); ++i) ::dup2(copies[i], static_cast<int>(i));
  if (::syscall(SYS_close_range, count, ~0U, CLOSE_RANGE_CLOEXEC) == 0 && ::chdir(folder.c_str()) == 0 &&
      ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
      ::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0)
    ::execve(program_file.c_str(), words.data(), variables.data());
  const bool is_told = ::write(said[1], "x", 1) == 1;
  ::_exit(is_told ? 1 : 2);
}

bool kill_all_of(unsigned user) {
  for (int i = 0; i < 3000; ++i) {
    // The kernel asks for the sender's real or effective id, and for the receiver's real or saved one. So it
    // reaches all of the user's processes, and none of them reaches it.
    const pid_t killer = ::fork();
    if (killer == 0) {
      if (::syscall(SYS_setresuid, user + 1, user, user + 1) == 0) ::kill(-1, SIGKILL);
      ::_exit(0);
    }
    if (killer > 0) ::waitpid(killer, nullptr, 0);
    if (usage_of_all(Descriptor(::open("/proc", O_RDONLY | O_DIRECTORY | O_CLOEXEC)), user).processes == 0)
      return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

}  // namespace texel::sandbox
