// SPDX-License-Identifier: MIT
// Which of a student's failed steps comes first: without the solution nobody can judge a step alone.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "judge/results.hpp"

namespace texel::check {

/// Other steps that were written anew since a step passed, in the course's order.
struct Changed {
  std::vector<std::string> steps;
  bool by_last_save = false;  ///< all of them, since the check before this one
};

/// Compares the checked steps with what `file` remembers of earlier checks, and remembers them there.
/// Returns, by step, what changed since it passed: of steps that fail now, passed once, and have the same
/// text since. Steps of other labs do not matter: each lab stands alone. `texts` has what
/// stands between each step's markers. A memory that is missing or broken is empty. Throws Error (exit 3)
/// when it cannot be written.
std::map<std::string, Changed> changed_since_it_passed(const std::filesystem::path& file,
                                                       const std::map<std::string, std::string>& texts,
                                                       const std::vector<judge::LabResult>& labs);

/// Skips failed steps before which others come, and says why: those that passed before another one changed;
/// and those that need a step that did not pass. But where nothing explains why that one failed (it was
/// begun, and shows no known mistake), and the step's own pictures show a known mistake, it is not skipped: a
/// wrong line spoils pictures of earlier steps too. The labs have those that they need before them.
void skip_those_that_wait(std::vector<judge::LabResult>& labs, const std::map<std::string, Changed>& changed);

}  // namespace texel::check
