// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

namespace texel::assets {

/// Whether each file under `fresh` is in `committed` too, with the same bytes; pictures may be packed by
/// another version of zlib, and differ by one step where another library's sine rounds the other way. Prints
/// what differs.
bool same_files(const std::filesystem::path& fresh, const std::filesystem::path& committed);

}  // namespace texel::assets
