// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "core/files.hpp"

namespace texel::sandbox {

/// Opens what is called `name` in a folder for reading, without following a link and without waiting for a
/// pipe; not open when it cannot.
Descriptor open_in(const Descriptor& folder, const std::string& name);

/// The names in a folder in the order of their bytes, at most `most` of them; none when it cannot be read.
std::vector<std::string> names_in(const Descriptor& folder, std::size_t most);

/// The first `most` bytes of an open file, or all when it has fewer.
std::string read_some(const Descriptor& file, std::size_t most);

}  // namespace texel::sandbox
