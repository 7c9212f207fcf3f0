// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "grade/course_tree.hpp"

/// A lab between starter and solution, as a student has it on the way.
namespace texel::grade {

/// The steps that are solved, as "5.1".
using Solved = std::set<std::string>;

/// A lab with some steps solved.
struct Stage {
  std::filesystem::path program;
  std::filesystem::path root;  ///< the folder with shaders/ and assets/
};

/// The lab at each of the stages. Their shaders are written into `folder`, which is empty; their programs are
/// kept in the tree's cache. Throws Error (exit 3) when a stage does not build.
std::map<Solved, Stage> make_stages(const CourseTree& tree, const course::Lab& lab,
                                    const std::vector<Solved>& stages, const std::filesystem::path& folder);

}  // namespace texel::grade
