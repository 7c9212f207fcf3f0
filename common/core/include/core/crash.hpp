// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

namespace texel {

/// From now on this program says where it crashed or used up its processor time: standard error has the
/// addresses of the calls, the innermost first.
void report_crashes();

/// The innermost call in a file of `folder` when a program died that had called report_crashes and wrote
/// `errors`, as "labs/03_obj/a.cpp:41"; "" where none is known, which takes -g1 and addr2line.
std::string crash_place(const std::string& errors, const std::filesystem::path& program,
                        const std::filesystem::path& folder);

}  // namespace texel
