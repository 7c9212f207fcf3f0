// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "course/lab_file.hpp"

namespace texel::tools {

/// The look's picture below the gallery's folder: "05_normal_map/bricks.png".
std::string picture(const course::Lab& lab, const course::Look& look);

/// The lab's picture for README and handout: the first look with `hero`, or null.
const course::Look* hero_of(const course::Lab& lab);

/// That picture small: the middle of `from`, as large as fits into 3:2, at half its size, averaged in linear
/// light.
void save_hero(const std::filesystem::path& from, const std::filesystem::path& to);

/// The whole page as HTML. It names the pictures by their place below its own folder, and nothing else
/// outside of itself. `renderer` says what drew them.
std::string gallery_page(const std::vector<course::Lab>& labs, const std::string& renderer);

}  // namespace texel::tools
