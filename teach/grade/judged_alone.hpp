// SPDX-License-Identifier: MIT
// One step of a student among the solution's others: so a mistake costs the step in which it was made.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "class_setup.hpp"
#include "grade/grader.hpp"
#include "judge/plan.hpp"

namespace texel::grade {

/// Draws cases of one step into the folder `out`, where the solution stands in for all other steps: in the
/// step's files what stands between their markers is the solution's, and all other files of the lab, and
/// those that labs share, are the solution's. So the program of a GLSL step has no C++ of the student.
/// Shaders are laid out in the folder `work`.
///
/// The student's text is compiled and drawn beside the solution's, in the sandbox, and could carry it out. So
/// nothing but the pictures comes back, for the judge alone: not what programs, compiler and driver say, and
/// not why a picture is missing. Of cases that were refused (Drawn::refused) their file and place come back,
/// for grade::recognise alone. Nothing comes back where markers in the step's files are gone. Throws Error
/// (exit 3), which says nothing of the files either, for faults of the machine. All of it counts to the
/// student's time.
std::optional<std::map<std::string, std::string>> draw_alone(
    const ClassSetup& setup, const GradeOptions& options, const std::map<std::string, std::string>& files,
    const judge::LabPlan& plan, const std::string& step, const std::vector<course::Case>& cases,
    const std::filesystem::path& work, const std::filesystem::path& out, TimeBudget* budget);

/// A mark, or an error in the case's unit, of such pictures, in steps of a hundredth of it at least: exact
/// numbers could carry text out. The mark is rounded down.
double coarse_score(double score);
double coarse_error(double error);

}  // namespace texel::grade
