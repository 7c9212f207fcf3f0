// SPDX-License-Identifier: MIT
#pragma once
#include <set>
#include <string>
#include <vector>

#include "grade/submission.hpp"

/// Files that held steps in starters before steps lay in labs and shaders alone. Students may still hand them
/// in.
namespace texel::grade {

/// The older files of which a step lies in one of these files now.
std::set<std::string> older_files(const std::vector<std::string>& allowed);

/// The steps that a student began in the text of an allowed or older file: those whose markers the text has
/// and whose code is not the starter's. One without a marker may be another file of that name.
std::set<std::string> begun_steps(const std::string& file, const std::string& text,
                                  const FirstText& first_text);

/// Takes the steps that were begun in older files into the files that have them now, and the older files out
/// of `files`. What is begun in a file of today stays. Says in `ignored` what became of each older file.
void take_older_steps(Submission& submission, const FirstText& first_text);

}  // namespace texel::grade
