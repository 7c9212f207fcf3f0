// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

/// The places in the sources where a student writes. Solution and starter are one text:
///
///     //@STEP begin
///     return color * 2.0 - 1.0;
///     //@starter
///     // return color;
///     //@end
///
/// STEP is the word step and its number (begin_marker). Each marker is alone in its line. Between the first
/// two is the solution; between the last two, in comments, is the starter's code.
namespace texel::course {

/// The line with which a step's text begins.
std::string begin_marker(const std::string& step);

/// A place of a step in a text, in offsets: its markers' lines, and what stands between them.
struct StepPart {
  std::string step;
  int line;  ///< of its first marker, from 1
  std::size_t begin, text, text_end = std::string::npos, end = std::string::npos;

  [[nodiscard]] bool is_whole() const { return end != std::string::npos; }
  [[nodiscard]] std::string of(const std::string& all) const { return all.substr(text, text_end - text); }
};

/// The places of all steps in a text, in its order. One whose end is missing is not whole. Only the markers'
/// own words are markers: any other line, as `//@todo`, is the student's own.
std::vector<StepPart> parts_of(const std::string& text);

/// Whether a line is a marker of a student's or of the course's text.
bool is_marker(std::string_view line);

/// What is wrong with the markers of a student's text, as a sentence by step: of those that the first text
/// has. A damaged marker costs no other step.
std::map<std::string, std::string> marker_faults(const std::string& text, const std::string& first,
                                                 const std::string& file);

/// The text between each step's markers in a student's file, by step; several parts of a step follow each
/// other. Parts without an end are left out.
std::map<std::string, std::string> step_texts(const std::string& text);

/// A text of the course with one of the two parts of each step: the solution where `solved(step)`, else the
/// starter's. The markers around it stay: they show where to write. Throws Error (exit 3) with file and line
/// for a marker that is unknown, unpaired, nested or not alone in its line.
std::string with_steps(const std::string& text, const std::string& file,
                       const std::function<bool(const std::string&)>& solved);

/// Whether two texts of GLSL or C++ differ in comments and white space alone. A line's end counts as a space.
/// False where it takes more than a look: texts with a raw string, a digit separator, or a backslash outside
/// literals must be equal byte by byte.
bool is_same_code(std::string_view a, std::string_view b);

/// The steps that nobody began: what a compiler reads between their markers is what the first text has
/// (is_same_code). A step with damaged markers was begun.
std::set<std::string> untouched_steps(const std::string& text, const std::string& first);

/// A student's text, with the part between one step's markers taken from another text of the same file.
/// Throws Error (exit 3) when the markers of that step are damaged.
std::string with_step_from(const std::string& text, const std::string& file, const std::string& step,
                           const std::string& other);

/// The files that a student may change, as paths in the tree: every file below labs and shaders with a
/// begin_marker. In a student's tree they are those that its starter had: a copy that lies beside one is no
/// other step. Sorted. Throws Error (exit 3) when there is none.
std::vector<std::string> step_files(const std::filesystem::path& tree);

/// Where each step is written in a student's tree or in the course's, as its files are now; a step whose
/// marker is gone, where a starter has it. Throws Error (exit 3) as step_files and first_text.
std::map<std::string, Place> step_places(const std::filesystem::path& tree);

/// Where a student's tree keeps its files with steps as they were at first, by their path in the tree.
inline constexpr const char* kFirstTexts = ".starter";

/// The first version of a file with steps, from the course's tree or from a student's. Throws Error (exit 3)
/// when it cannot be read, and as with_steps.
std::string first_text(const std::filesystem::path& tree, const std::string& file);

}  // namespace texel::course
