// SPDX-License-Identifier: MIT
// Which of a student's failed steps comes first: without the solution nobody can judge a step alone.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "judge/results.hpp"

namespace texel::check {

/// Compares the steps with what `file` remembers of earlier checks, and remembers those that passed. Returns,
/// by step, the steps of its lab that were written anew since it passed: of those that fail now and have the
/// text with which they passed. `texts` has what stands between each step's markers. A memory that is missing
/// or broken is empty. Throws Error (exit 3) when it cannot be written.
std::map<std::string, std::vector<std::string>> changed_since_it_passed(
    const std::filesystem::path& file, const std::map<std::string, std::string>& texts,
    const std::vector<judge::LabResult>& labs);

/// Skips failed steps before which others come, and says why: those that passed before another one changed;
/// and those that need a step that did not pass. But where nothing explains why that one failed (it was
/// begun, and shows no known mistake), and the step's own pictures show a known mistake, it is not skipped: a
/// wrong line spoils pictures of earlier steps too.
void skip_those_that_wait(judge::LabResult& lab,
                          const std::map<std::string, std::vector<std::string>>& changed);

}  // namespace texel::check
