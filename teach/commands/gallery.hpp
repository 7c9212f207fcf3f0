// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "commands.hpp"
#include "core/error.hpp"
#include "course/lab_file.hpp"

namespace texel::commands {

/// The lab's picture for README and handout: the first look with `hero`, or null.
const course::Look* hero_of(const course::Lab& lab);

/// That picture small: the middle of `from`, as large as fits into 3:2, at half its size, averaged in linear
/// light.
void save_hero(const std::filesystem::path& from, const std::filesystem::path& to);

/// `texel gallery --heroes FOLDER`: saves the small pictures of the gallery's labs into it.
void save_heroes(const tools::GalleryOptions& gallery, const std::filesystem::path& folder);

/// `texel gallery --list`: prints docs/pictures.md, the sources' pictures with their commands.
Exit list_sources();

}  // namespace texel::commands
