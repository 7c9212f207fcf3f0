// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "grade/course_tree.hpp"
#include "judge/results.hpp"

/// Whether marks are earned: what right and wrong solutions of each step get.
namespace texel::grade {

struct JudgedSolution {
  std::string name;  ///< the entry of the catalogue, or the place
  bool is_right = false;
  std::vector<judge::StepResult> by_seed;
  /// The mistake that the grader takes it for, by the first seed, and what it is to be; or both "".
  std::string called, is_called;
};

/// Judges the solution with each place of a step as the starter has it, and, unless `only_places`, each
/// mutant and each equivalent of the catalogues, with so many seeds. `say` gets progress. Throws Error
/// (exit 3) when something does not draw.
std::vector<JudgedSolution> judged_solutions(const CourseTree& tree, int seeds, bool only_places,
                                             const std::function<void(const std::string&)>& say);

}  // namespace texel::grade
