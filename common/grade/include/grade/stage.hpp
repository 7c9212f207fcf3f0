// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <vector>

#include "grade/check.hpp"

/// The course's tree between starter and solution, as a student sees it on the way.
namespace texel::grade {

/// A lab with its first steps solved.
struct Stage {
  std::filesystem::path program;
  std::filesystem::path root;  ///< the folder with shaders/ and assets/
};

/// The stages of one lab: the k-th has its first k steps solved, all steps of earlier labs, and none of later
/// ones. `tree.labs` are all labs of the course. The stages' shaders are written into `folder`; their programs
/// are kept in the tree's cache. Throws Error (exit 3) when a stage does not build.
std::vector<Stage> make_stages(const CourseTree& tree, const course::Lab& lab,
                               const std::filesystem::path& folder);

}  // namespace texel::grade
