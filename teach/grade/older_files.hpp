// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <string>
#include <vector>

#include "grade/submission.hpp"

/// Files that held steps in starters before steps lay in labs and shaders alone. Students may still hand them
/// in.
namespace texel::grade {

/// A step that an older starter had in another file.
struct MovedStep {
  std::string step, from, to;
};

/// Those of an older starter's file; none for any other file.
std::vector<MovedStep> moved_steps(const std::string& older_file);

/// The older files of which a step lies in one of these files now.
std::vector<std::string> older_files(const std::vector<std::string>& allowed);

/// Takes the steps that were begun in older files into the files that have them now, and the older files out
/// of `files`. What is begun in a file of today stays. Says in `ignored` what became of each older file.
void take_older_steps(Submission& submission, const FirstText& first_text);

}  // namespace texel::grade
