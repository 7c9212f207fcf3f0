// SPDX-License-Identifier: MIT
// A program that tries to do harm, for the tests of the sandbox: sandbox_guest WHAT [WHERE]. It says on
// standard output what it could do.
#include <fcntl.h>
#include <linux/keyctl.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/ptrace.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Runs before main, as a student's static constructor may.
const bool leaves_early = [] {
  if (std::getenv("GUEST_LEAVES") != nullptr) ::_exit(0);
  return false;
}();

void say(const char* what, bool could) {
  std::printf("%s: %s\n", what, could ? "possible" : std::strerror(errno));
  std::fflush(stdout);
}

[[noreturn]] void wait_for_ever() {
  while (true) ::pause();
}

[[noreturn]] void spin() {
  volatile unsigned rounds = 0;
  while (true) rounds = rounds + 1;
}

/// Writes until the disk is full, then sits there.
[[noreturn]] void fill(const std::string& folder) {
  const std::vector<char> block(1U << 16U);
  ::signal(SIGXFSZ, SIG_IGN);
  for (int i = 0;; ++i) {
    const std::string path = folder + "/" + std::to_string(i);
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT, 0600);
    while (file >= 0 && ::write(file, block.data(), block.size()) > 0) {
    }
    ::close(file);
  }
}

void make_files(const std::string& folder, off_t size) {
  for (int i = 0; i < 20; ++i) {
    const int file = ::open((folder + "/" + std::to_string(i)).c_str(), O_WRONLY | O_CREAT, 0600);
    say("a file", ::ftruncate(file, size) == 0);
  }
}

void leave_results(const std::string& folder) {
  fs::create_directories(folder + "/sub");
  std::ofstream(folder + "/picture.png") << "a picture";
  std::ofstream(folder + "/sub/more.ply") << "a mesh";
  fs::create_symlink("/etc/passwd", folder + "/link.png");
  fs::create_directory_symlink("/etc", folder + "/folder");
  ::mkfifo((folder + "/pipe.png").c_str(), 0600);
}

/// Folders in folders, whose path is longer than the system takes, with a file in the last.
void leave_deep_folders(const std::string& folder) {
  if (::chdir(folder.c_str()) != 0) return;
  const std::string name(255, 'n');
  for (int i = 0; i < 16; ++i)
    if (::mkdir(name.c_str(), 0755) != 0 || ::chdir(name.c_str()) != 0) return;
  std::ofstream("file") << "x";
}

/// Forks until it cannot, and says how often it could.
void count_forks() {
  int count = 0;
  for (pid_t child = ::fork(); child >= 0; child = ::fork(), ++count)
    if (child == 0) wait_for_ever();
  std::printf("%d\n", count);
}

/// Starts a process that no longer belongs to it: another session, another parent.
void leave_daemon() {
  if (::fork() != 0) return;
  ::setsid();
  if (::fork() != 0) ::_exit(0);
  wait_for_ever();
}

void try_forbidden() {
  say("ptrace", ::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) == 0);
  say("mount", ::mount("none", "/tmp", "tmpfs", 0, nullptr) == 0);
  say("unshare", ::syscall(SYS_unshare, 0x10000000) == 0);                          // CLONE_NEWUSER
  say("clone", ::syscall(SYS_clone, 0x10000000 | SIGCHLD, nullptr, 0, 0, 0) >= 0);  // the same
  say("keyctl", ::syscall(SYS_keyctl, KEYCTL_GET_KEYRING_ID, KEY_SPEC_USER_KEYRING, 1) >= 0);
  say("bpf", ::syscall(SYS_bpf, 0, nullptr, 0) >= 0);
  say("userfaultfd", ::syscall(SYS_userfaultfd, 1) >= 0);
  say("io_uring", ::syscall(SYS_io_uring_setup, 1, nullptr) >= 0);
  say("perf", ::syscall(SYS_perf_event_open, nullptr, 0, -1, -1, 0) >= 0);
  say("memfd", ::syscall(SYS_memfd_create, "x", 0) >= 0);
  say("shmget", ::syscall(SYS_shmget, 0, 4096, 01600) >= 0);
}

/// Fills the buffers of pipes, as large as it may make them, and says how many bytes lie there.
void fill_buffers() {
  const std::vector<char> block(1U << 16U);
  long long bytes = 0;
  for (int ends[2]; ::pipe2(ends, O_NONBLOCK) == 0;) {
    ::fcntl(ends[1], F_SETPIPE_SZ, 1 << 20);
    for (ssize_t put = 0; (put = ::write(ends[1], block.data(), block.size())) > 0;) bytes += put;
  }
  std::printf("%lld\n", bytes);
}

/// Takes memory that no process shows: page tables of 6 MiB for each of 60 processes, for pages that were
/// only read.
[[noreturn]] void fill_page_tables() {
  constexpr std::size_t size = 3ULL << 30U, table = 2U << 20U;
  for (int i = 0; i < 60; ++i) {
    if (::fork() != 0) continue;
    void* const mapped = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (mapped == MAP_FAILED) wait_for_ever();
    ::madvise(mapped, size, MADV_NOHUGEPAGE);
    volatile char sum = 0;
    for (std::size_t at = 0; at < size; at += table) sum = sum + static_cast<const char*>(mapped)[at];
    wait_for_ever();
  }
  wait_for_ever();
}

void try_signals(pid_t outside) {
  say("signal to the grader", ::kill(outside, 0) == 0);
  say("signal to its group", ::kill(-outside, 0) == 0);
  say("signal to process 1", ::kill(1, SIGKILL) == 0 && false);  // the kernel takes it and does nothing
}

/// Several processes that each take less processor time than all of them together.
void spin_together() {
  for (int i = 0; i < 3; ++i)
    if (::fork() == 0) spin();
  while (::wait(nullptr) > 0) {
  }
}

void list(const char* folder) {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    std::printf("%s\n", entry.path().filename().c_str());
}

}  // namespace

int main(int argc, char** argv) {
  const std::string what = argc > 1 ? argv[1] : "";
  const std::string where = argc > 2 ? argv[2] : "";
  if (what == "exit") return std::atoi(where.c_str());
  if (what == "abort") std::abort();
  if (what == "print") std::printf("%s\n", where.c_str());
  if (what == "read") say("reading", std::ifstream(where).good());
  if (what == "write") say("writing", (std::ofstream(where) << "x" << std::flush).good());
  if (what == "list") list(where.c_str());
  if (what == "input") std::printf("%d\n", std::getchar());
  if (what == "namespaces")
    for (const char* name : {"net", "ipc", "pid", "uts", "mnt"})
      std::printf("%s\n", fs::read_symlink(std::string("/proc/self/ns/") + name).c_str());
  if (what == "room") std::printf("%ju\n", fs::space(where).capacity);
  if (what == "team") spin_together();
  if (what == "network") {
    for (const int family : {AF_INET, AF_INET6, AF_NETLINK, AF_PACKET})
      say("socket", ::socket(family, SOCK_RAW, 0) >= 0);
    say("stream", ::socket(AF_INET, SOCK_STREAM, 0) >= 0);
    say("local", ::socket(AF_UNIX, SOCK_STREAM, 0) >= 0);
    int ends[2];
    say("pair", ::socketpair(AF_UNIX, SOCK_STREAM, 0, ends) == 0);
  }
  if (what == "environment")
    for (char** variable = environ; *variable != nullptr; ++variable) std::printf("%s\n", *variable);
  if (what == "forbidden") try_forbidden();
  if (what == "signals") try_signals(std::atoi(where.c_str()));
  if (what == "results") leave_results(where);
  if (what == "deep") leave_deep_folders(where);
  if (what == "holes") make_files(where, 1 << 20);
  if (what == "forks") count_forks();
  if (what == "daemon") leave_daemon();
  if (what == "sleep") wait_for_ever();
  if (what == "fill") fill(where);
  if (what == "spin") spin();
  if (what == "ignore") {
    ::signal(SIGXCPU, SIG_IGN);
    spin();
  }
  if (what == "bomb")
    while (true) ::fork();
  if (what == "pipes") fill_buffers();
  if (what == "tables") fill_page_tables();
  if (what == "memory")
    while (true) std::memset(new char[1U << 24U], 1, 1U << 24U);
  if (what == "huge") {
    volatile char* huge = new char[1ULL << 40U];  // volatile: what nobody reads is not asked for
    huge[0] = 1;
  }
  if (what == "flood")
    while (true) std::fputs("score: 100 of 100\n", stdout);
  return 0;
}
