// SPDX-License-Identifier: MIT
#include "filter.hpp"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace texel::sandbox {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0;
#endif

constexpr std::uint32_t x32_calls = 0x40000000;  // x86-64's second table of system calls starts here

constexpr std::uint32_t new_namespaces =
    CLONE_NEWNS | CLONE_NEWCGROUP | CLONE_NEWUTS | CLONE_NEWIPC | CLONE_NEWUSER | CLONE_NEWPID | CLONE_NEWNET;

/// Calls that fail with EPERM.
constexpr long forbidden[] = {
    // Other processes and the kernel.
    SYS_ptrace, SYS_process_vm_readv, SYS_process_vm_writev, SYS_kcmp, SYS_pidfd_getfd, SYS_process_madvise,
    SYS_bpf, SYS_perf_event_open, SYS_userfaultfd, SYS_io_uring_setup, SYS_io_uring_enter,
    SYS_io_uring_register, SYS_keyctl, SYS_add_key, SYS_request_key, SYS_init_module, SYS_finit_module,
    SYS_delete_module, SYS_kexec_load, SYS_kexec_file_load, SYS_reboot, SYS_syslog, SYS_acct, SYS_quotactl,
    SYS_swapon, SYS_swapoff, SYS_settimeofday, SYS_clock_settime, SYS_clock_adjtime, SYS_adjtimex,
#ifdef SYS_iopl
    SYS_iopl, SYS_ioperm,
#endif
    // Namespaces and mounts.
    SYS_unshare, SYS_setns, SYS_chroot, SYS_pivot_root, SYS_mount, SYS_umount2, SYS_move_mount, SYS_open_tree,
    SYS_fsopen, SYS_fsconfig, SYS_fsmount, SYS_fspick, SYS_mount_setattr, SYS_name_to_handle_at,
    SYS_open_by_handle_at, SYS_fanotify_init,
    // Memory that outlives its mapping, so that neither RLIMIT_AS nor the resident size counts it.
    SYS_memfd_create, SYS_memfd_secret, SYS_shmget, SYS_msgget, SYS_semget, SYS_mq_open,
    // Sockets, even between processes of the sandbox: nothing to reach, and what lies in their buffers is
    // counted by no limit.
    SYS_socket, SYS_socketpair};

class Program {
 public:
  void load(std::size_t offset) { add(BPF_LD | BPF_W | BPF_ABS, 0, 0, static_cast<std::uint32_t>(offset)); }
  void give(std::uint32_t action) { add(BPF_RET | BPF_K, 0, 0, action); }
  void give_error(int error) { give(SECCOMP_RET_ERRNO | static_cast<std::uint32_t>(error)); }

  /// Skips as many of the next instructions when the loaded word compares so (`unless`: when it does not).
  void skip_if(std::uint16_t comparison, std::uint32_t value, std::uint8_t count) {
    add(static_cast<std::uint16_t>(BPF_JMP | comparison | BPF_K), count, 0, value);
  }
  void skip_unless(std::uint16_t comparison, std::uint32_t value, std::uint8_t count) {
    add(static_cast<std::uint16_t>(BPF_JMP | comparison | BPF_K), 0, count, value);
  }

  [[nodiscard]] std::string bytes() const {
    return {reinterpret_cast<const char*>(instructions_.data()), instructions_.size() * sizeof(sock_filter)};
  }

 private:
  void add(std::uint16_t code, std::uint8_t if_true, std::uint8_t if_false, std::uint32_t value) {
    instructions_.push_back({code, if_true, if_false, value});
  }
  std::vector<sock_filter> instructions_;
};

}  // namespace

std::string seccomp_filter() {
  if constexpr (architecture == 0) return {};
  // The low half of the first argument; both processors are little-endian.
  constexpr std::size_t first_argument = offsetof(seccomp_data, args);
  Program program;
  program.load(offsetof(seccomp_data, arch));
  program.skip_if(BPF_JEQ, architecture, 1);
  program.give(SECCOMP_RET_KILL_PROCESS);

  program.load(offsetof(seccomp_data, nr));
  program.skip_unless(BPF_JGE, x32_calls, 1);
  program.give_error(ENOSYS);
  for (const long call : forbidden) {
    program.skip_unless(BPF_JEQ, static_cast<std::uint32_t>(call), 1);
    program.give_error(EPERM);
  }
  // clone3 has its flags in memory, where a filter cannot look: the C library then takes clone.
  program.skip_unless(BPF_JEQ, SYS_clone3, 1);
  program.give_error(ENOSYS);

  program.skip_unless(BPF_JEQ, SYS_clone, 4);
  program.load(first_argument);
  program.skip_unless(BPF_JSET, new_namespaces, 1);
  program.give_error(EPERM);
  program.give(SECCOMP_RET_ALLOW);

  program.give(SECCOMP_RET_ALLOW);
  return program.bytes();
}

}  // namespace texel::sandbox
