// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "judge/plan.hpp"

namespace texel::grade {

/// All cases of the labs, the hidden ones too. Their values are drawn from the seed, the lab, the case and
/// the parameter: they stay the same for all submissions, and when other cases come or go. Models that nobody
/// has seen are written into `models`. Throws Error (exit 3) when the folder cannot be written.
std::vector<judge::LabPlan> full_plan(const std::vector<course::Lab>& labs, const std::string& seed,
                                      const std::filesystem::path& models);

/// The views `mask` of the plan's pictures, for the cases that have one.
std::vector<course::Case> masks_of(const judge::LabPlan& plan);

}  // namespace texel::grade
