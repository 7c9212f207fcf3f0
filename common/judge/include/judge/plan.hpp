// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "course/lab_file.hpp"

/// Which pictures are drawn to judge a lab: its cases with every parameter settled.
namespace texel::judge {

struct LabPlan {
  course::Lab lab;
  std::vector<course::Case> cases;  ///< in the file's order
};

/// The cases that students can check: all but the hidden ones.
std::vector<LabPlan> public_plan(const std::vector<course::Lab>& labs);

/// The command that draws the case, typed in the project's root: "./run lab 5 --model torus --view normal
/// --size 128x128 --snapshot decode.pfm".
std::string command(const course::Lab& lab, const course::Case& of);

}  // namespace texel::judge
