// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>

namespace texel {

/// From now on this program says where it crashed or used up its processor time: standard error has the
/// addresses of the calls, the innermost first.
void report_crashes();

/// Where a program crashed that had called report_crashes, by what it wrote: the innermost call in a file of
/// `folder`, as "labs/03_obj_texcoords/triangulate.cpp:41". "" where there is none, the program was compiled
/// without lines, or addr2line, a part of the linker's package, is missing.
std::string crash_place(const std::string& errors, const std::filesystem::path& program,
                        const std::string& folder);

}  // namespace texel
