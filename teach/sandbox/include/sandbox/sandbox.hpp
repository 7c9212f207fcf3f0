// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "core/process.hpp"

/// Programs that nobody trusts, run where they can do no harm.
///
/// The walls are bubblewrap's: new user (or, for root, an id that nobody else has), process, network, mount,
/// IPC, host-name and control-group namespaces; of the file system only /usr and what the dynamic linker
/// needs, all read-only; a /proc and /tmp of its own; no capability; a seccomp filter; no terminal; nothing
/// on standard input; none of the caller's open files and environment. Everything in it dies with the
/// program, and with the caller.
///
/// What is installed below /usr can be read, so that solutions and references must lie elsewhere. As root,
/// the program runs under another id: what it shall read must be open to others.
namespace texel::sandbox {

/// Runs `command` (a program and its arguments, no shell) and waits for its end. May be called by many
/// threads at once.
///
/// Throws Error (exit 3) when the sandbox is at fault and not the program: bubblewrap is missing or cannot
/// work here, a folder is missing, the results cannot be copied. Throws Error (exit 2) for an empty command
/// and a path that is not absolute.
Outcome run_locked_in(const Confines& confines, const std::vector<std::string>& command);

/// The same where nobody may make namespaces, as in the container of an autograder: the program runs under an
/// id that nobody else has, without any right and with the seccomp filter. So it reaches no network, no other
/// user's process and no file that is closed to others. It has all limits; every process of its id is killed
/// at the end. **What does not hold:** it sees which processes run, and reads and writes all that is open to
/// everybody. So the caller must be root, close what is secret, run one program at a time, and throw the
/// machine away afterwards. Throws as `run_locked_in`.
Outcome run_as_another_user(const Confines& confines, const std::vector<std::string>& command);

/// Why programs cannot be run so on this machine, or "" when they can. Tried once.
const std::string& another_user_fault();

/// Why programs cannot be locked in on this machine, or "" when they can. Tried once.
const std::string& sandbox_fault();

/// Why the kernel does not count a sandbox's memory on this machine, or "" when it does: it is then held to
/// its limit by what its processes show, every few milliseconds. Tried once, when the first sandbox starts or
/// when asked; from then on this process is in a control group of its own.
const std::string& memory_group_fault();

}  // namespace texel::sandbox
