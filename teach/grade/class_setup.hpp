// SPDX-License-Identifier: MIT
// The first part of grading a class: everything that is the same for all students.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "course/lab_file.hpp"
#include "grade/grader.hpp"
#include "references.hpp"
#include "workshop.hpp"

namespace texel::grade {

struct ClassSetup {
  std::vector<course::Lab> labs;     ///< that are asked for and have steps
  std::vector<course::Lab> plans;    ///< theirs
  std::string seed;                  ///< the course's secret
  std::filesystem::path models;      ///< models that nobody has seen
  std::vector<std::string> allowed;  ///< files that a student may change
  std::map<std::string, std::uint64_t>
      given;  ///< the sizes of all files that students get, by path in small letters
  std::map<std::string, std::string> solution;                 ///< the same with all steps solved, by path
  std::map<std::string, std::set<std::string>> files_of_step;  ///< the paths of those with a part of it
  BuiltTree starter;
  std::unique_ptr<References> course;  ///< the solution, and what it draws
  std::unique_ptr<Workshop> workshop;  ///< where students' programs are made
};

/// Reads the course, makes the seed unless there is one, builds the starter, and has the solution and the
/// starter draw all cases, `jobs` labs at a time. Throws Error: exit 2 when no lab that is asked for has
/// steps, exit 3 when something does not build or draw.
ClassSetup prepare(const GradeOptions& options, unsigned jobs);

}  // namespace texel::grade
