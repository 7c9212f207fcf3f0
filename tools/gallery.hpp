// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "course/lab_file.hpp"

namespace texel::tools {

/// The lab's picture for README and handout: the first look with `hero`, or null.
const course::Look* hero_of(const course::Lab& lab);

/// That picture small: the middle of `from`, as large as fits into 3:2, at half its size, averaged in linear
/// light.
void save_hero(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace texel::tools
