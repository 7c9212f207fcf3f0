// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "course/lab_file.hpp"

namespace texel::grade {

/// The labs with all parameters of their cases resolved. Hidden values are drawn from the seed, the lab, the
/// case and the parameter: they stay the same for all submissions, and when other cases come or go. Models
/// that nobody has seen are written into `models`. Throws Error (exit 3) when the folder cannot be written,
/// or there is nothing to draw from.
std::vector<course::Lab> full_plan(std::vector<course::Lab> labs, const std::string& seed,
                                   const std::filesystem::path& models);

/// The views `mask` of the plan's pictures, for the cases that have one.
std::vector<course::Case> masks_of(const course::Lab& plan);

}  // namespace texel::grade
