// SPDX-License-Identifier: MIT
#pragma once
#include "grade/grader.hpp"

/// What must hold besides when a student's programs run as another user (`run_as_another_user`).
namespace texel::grade {

/// Closes to other users what the grader writes and no program of a student may read: the results, references
/// and the solutions' programs. The cache's other folders can be entered, but not listed. Throws Error (exit
/// 3) when that fails.
void restrict_access(const GradeOptions& options);

/// Tries as another user to read the course, its programs, the seed and what `restrict_access` closed, and to
/// write where a program could leave something for a later one. Throws Error (exit 3) with what is open.
void check_access(const GradeOptions& options);

}  // namespace texel::grade
