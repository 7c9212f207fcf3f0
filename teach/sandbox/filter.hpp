// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace texel::sandbox {

/// The seccomp filter of the sandbox, as bwrap's --seccomp takes it: an array of `struct sock_filter`. It
/// refuses the system calls that no lab needs and that break out of sandboxes or hold memory which no limit
/// counts. Empty for a processor whose calls we do not know.
std::string seccomp_filter();

}  // namespace texel::sandbox
