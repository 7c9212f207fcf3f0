// SPDX-License-Identifier: MIT
// What the grader makes once and keeps in its cache: starters, objects, programs, the course's own pictures.
// Each is a folder under the fingerprint of what it was made of, and its time of change is when it was used
// last.
#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>

namespace texel::grade {

/// 64 hexadecimal digits that stand for these texts and no others: BLAKE2b, each text with its length before
/// it. Nobody can make two that collide, so that what is kept under a fingerprint is of that very content.
std::string fingerprint(std::initializer_list<std::string_view> texts);

/// A fingerprint of a folder: the paths and contents of its files, or of those that count. Throws Error (exit
/// 3) when one cannot be read.
std::string fingerprint_of_folder(
    const std::filesystem::path& folder,
    const std::function<bool(const std::filesystem::path&)>& counts = [](const auto&) { return true; });

/// A number that follows from the texts, evenly spread, and from which no one can tell the texts.
std::uint64_t draw(std::initializer_list<std::string_view> texts);

/// Whether a folder of the cache is there; if so it counts as used now.
bool is_cached(const std::filesystem::path& folder);

/// Removes what nobody has used for a month, and starters, which are large, after a week. What is not called
/// by a fingerprint stays.
void remove_unused(const std::filesystem::path& cache);

}  // namespace texel::grade
