// SPDX-License-Identifier: MIT
#pragma once
#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

/// Walls without namespaces, for root in a container that forbids them: another user's id, and the filter on
/// system calls.
namespace texel::sandbox {

/// Starts `command` in a session of its own with the seccomp filter and no way to new rights. It gets copies
/// of `descriptors` as its 0, 1, 2, … and no other, and starts in `folder`. -1 if it could not be started so.
pid_t spawn_filtered(const std::vector<std::string>& command, const std::vector<std::string>& environment,
                     const std::string& filter, const std::vector<int>& descriptors,
                     const std::filesystem::path& folder);

/// Kills all processes of a user id, and waits until none is left. They cannot kill the killer first.
/// Whether all ended within half a minute.
bool kill_all_of(unsigned user);

}  // namespace texel::sandbox
