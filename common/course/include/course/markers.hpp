// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/error.hpp"

/// The places in the sources where a student writes. Solution and starter are one text:
///
///     //@step 5.1 begin
///     return color * 2.0 - 1.0;
///     //@starter
///     // return color;
///     //@end
///
/// Each marker is a line of its own. What stands between the first two is the solution; what stands between
/// the last two, without its comment signs, is what the student finds there. A part that is no step and that
/// students do not get, such as the right answer in double precision, begins with `//@teacher begin`. In
/// CMake files and scripts the markers begin with `#@`.
namespace texel::course {

/// A step's place in a file.
struct Marker {
  std::string step;  ///< "5.1"; "" for what is the teacher's
  int line = 0;      ///< of its first marker, from 1
};

/// The markers of a text, in its order. Throws Error (exit 3) with file and line for a marker that is
/// unknown, unpaired, nested or not alone in its line.
std::vector<Marker> markers_of(const std::string& text, const std::string& file);

/// What stands between each step's markers in a student's text, by step; parts of one step one after the
/// other. Errors as markers_of.
std::map<std::string, std::string> step_texts(const std::string& text, const std::string& file);

/// The text with one of the two parts of each step: the solution where `solved(step)`, else the starter's.
/// The markers around it stay, so that one sees where to write; those of the teacher's parts, which become
/// the starter's, go. Errors as markers_of.
std::string with_steps(const std::string& text, const std::string& file,
                       const std::function<bool(const std::string&)>& solved);

/// The steps between whose markers a text has what it had at first. A text whose markers are spoilt was
/// touched everywhere. Errors as markers_of, for the first text.
std::set<std::string> untouched_steps(const std::string& text, const std::string& first,
                                      const std::string& file);

/// The text with what stands between one step's markers taken from another text of the same file. Throws
/// Error (exit 3) when the two have not the same markers of that step, and as markers_of.
std::string with_step_from(const std::string& text, const std::string& file, const std::string& step,
                           const std::string& other);

/// The files that a student may change, as paths in the tree: every file below labs, shaders and common with
/// a line that begins with `//@step`. Sorted. Throws Error (exit 3) when there is none.
std::vector<std::string> step_files(const std::filesystem::path& tree);

/// Where each step is written in a student's tree, found in it or in the course's. Throws Error (exit 3) as
/// markers_of.
std::map<std::string, Place> step_places(const std::filesystem::path& tree);

/// Where a student's tree keeps its files with steps as they were at first, by their path in the tree.
inline constexpr const char* kFirstTexts = ".starter";

/// A file with steps as students get it, out of the course's tree or out of theirs. Throws Error (exit 3)
/// when it cannot be read, and as markers_of.
std::string first_text(const std::filesystem::path& tree, const std::string& file);

}  // namespace texel::course
