// SPDX-License-Identifier: MIT
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include "process.hpp"

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

sock_filter load(std::size_t offset) {
  return BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(offset));
}

sock_filter give(std::uint32_t action) {
  return BPF_STMT(BPF_RET | BPF_K, action);
}

/// Skips the next instructions: so many when the loaded word compares so, and so many when it does not.
sock_filter skip(int comparison, std::uint32_t value, std::uint8_t if_true, std::uint8_t if_false) {
  return BPF_JUMP(static_cast<std::uint16_t>(BPF_JMP | comparison | BPF_K), value, if_true, if_false);
}

}  // namespace

std::string seccomp_filter() {
  if constexpr (architecture == 0) return {};
  constexpr std::uint32_t not_permitted = SECCOMP_RET_ERRNO | EPERM,
                          no_such_call = SECCOMP_RET_ERRNO | ENOSYS;
  std::vector<sock_filter> program;
  const auto add = [&](std::initializer_list<sock_filter> part) { program.insert(program.end(), part); };
  add({load(offsetof(seccomp_data, arch)), skip(BPF_JEQ, architecture, 1, 0),
       give(SECCOMP_RET_KILL_PROCESS)});
  add({load(offsetof(seccomp_data, nr)), skip(BPF_JGE, x32_calls, 0, 1), give(no_such_call)});
  for (const long call : forbidden)
    add({skip(BPF_JEQ, static_cast<std::uint32_t>(call), 0, 1), give(not_permitted)});
  // clone3 has its flags in memory, where a filter cannot look: the C library then takes clone.
  add({skip(BPF_JEQ, SYS_clone3, 0, 1), give(no_such_call)});
  // clone has them in the low half of its first argument; both processors are little-endian.
  add({skip(BPF_JEQ, SYS_clone, 0, 3), load(offsetof(seccomp_data, args))});
  add({skip(BPF_JSET, new_namespaces, 0, 1), give(not_permitted)});
  add({give(SECCOMP_RET_ALLOW)});
  return {reinterpret_cast<const char*>(program.data()), program.size() * sizeof(sock_filter)};
}

}  // namespace texel::sandbox
