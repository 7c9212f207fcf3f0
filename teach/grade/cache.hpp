// SPDX-License-Identifier: MIT
// What the grader makes once and keeps in its cache: starters, objects, programs, the course's own pictures.
// Each is a folder under the fingerprint of what it was made of, and its time of change is when it was used
// last.
#pragma once
#include <filesystem>

namespace texel::grade {

/// Whether a folder of the cache is there; if so it counts as used now.
bool is_cached(const std::filesystem::path& folder);

/// Removes what nobody has used for a month, and starters, which are large, after a week. What is not called
/// by a fingerprint stays.
void remove_unused(const std::filesystem::path& cache);

}  // namespace texel::grade
