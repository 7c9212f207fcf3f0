// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "grade/course_tree.hpp"

/// Whether marks are earned: what right and wrong solutions of each step get.
namespace texel::grade {

/// How far a solution of a step is off, in the case where it is furthest.
struct Far {
  std::string by;          ///< the entry of the catalogue, the place, or "renderers"
  double times_limit = 0;  ///< infinite where nothing can be compared
  double error = 0, limit = 0;
  std::string unit, at;  ///< and the case
  double mark = 1;       ///< of the step, 0 to 1
};

/// A step's marks from both sides. Of the seeds, each solution has the one by which it is most like the other
/// side.
struct StepMarks {
  std::string step;
  std::vector<Far> mistakes;  ///< the smallest first
  std::vector<Far> rights;    ///< the furthest first
  /// How many times further the smallest mistake is off than any right answer; infinite where all that are
  /// right are the same.
  [[nodiscard]] double apart() const;
};

/// What renderers differ by, by lab and case.
using Spreads = std::map<std::pair<int, std::string>, double>;

/// Judges the solution with each place of a step as the starter has it, and, unless `only_places`, each
/// mutant and each equivalent of the catalogues, with so many seeds. `faults` gets a line for each mutant or
/// place that passes its step by a seed, and for each equivalent that fails. `say` gets progress. Throws
/// Error (exit 3) when something does not draw.
std::vector<StepMarks> marks_of(const CourseTree& tree, int seeds, bool only_places, const Spreads& spreads,
                                std::vector<std::string>& faults,
                                const std::function<void(const std::string&)>& say);

}  // namespace texel::grade
