// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>

#include "sandbox/descriptor.hpp"

namespace texel::sandbox {

/// Copies the regular files and folders of a folder that an untrusted program filled into a real one, over
/// what has the same name there. No link is followed; what is neither file nor folder, folders in more than
/// 16 others, and what cannot have its name there are left behind: the program chose them. Stops after
/// `limit` bytes, counting holes, and returns whether all was copied. Throws Error (exit 3) when the real
/// folder cannot be written.
bool copy_results(const Descriptor& from, const std::filesystem::path& to, std::uint64_t limit);

}  // namespace texel::sandbox
